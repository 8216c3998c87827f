// Functions compiled for wide registers too.
#pragma once

// Loops over whole rows gain most from wide registers: the loader picks the best version that the machine
// has.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#define REPLAN_WIDE __attribute__((target_clones("avx2", "default")))
#else
#define REPLAN_WIDE
#endif
