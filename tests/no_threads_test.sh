#!/bin/bash
# no_threads_test.sh LIBRARY...: libraries that were built without threads begin none.
for library in "$@"; do
  names=$(nm -C "$library" 2>/dev/null) || { echo "cannot read $library"; exit 1; }
  if found=$(grep -E 'pthread_create|_M_start_thread|std::(jthread|thread|stop_token|stop_source)' <<<"$names"); then
    echo "$library begins threads, but REPLAN_THREADS is off:"
    head -5 <<<"$found"
    exit 1
  fi
done
