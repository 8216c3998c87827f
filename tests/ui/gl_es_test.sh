#!/usr/bin/env bash
# Windows of OpenGL 3.3 core and of OpenGL ES 3.0, on a display of their own: they show the same frames, and where there is
# no core context the program opens one of ES by itself.
#   gl_es_test.sh PROGRAM TESTS
# Exit code 77: skipped, with the reason.
program=${1:?usage: gl_es_test.sh PROGRAM TESTS}
tests=${2:?usage: gl_es_test.sh PROGRAM TESTS}
. "$(dirname "$0")/window_support.sh"
for library in libEGL.so.1 libGLESv2.so.2; do ldconfig -p | grep -q "$library" || skip "$library is not installed"; done

# 1. The same frames.
REPLAN_OWN_DISPLAY=1 "$tests" --gtest_filter='GlEsWindow.*' >"$scratch/output" 2>&1 || fail "the frames differ"
grep -q "PASSED  . 1 test" "$scratch/output" || fail "the frames were not compared"

# 2. What is asked for, and what there is: Mesa can be told to have no OpenGL 3.3.
opens_with() {
  start_program "$scratch/world.json"
  xdotool key ctrl+q
  end_program "$1"
  expect opengl_es "$2" "$1"
}
opens_with "nothing asked for" false
REPLAN_GL=es opens_with "OpenGL ES asked for" true
MESA_GL_VERSION_OVERRIDE=2.1 opens_with "no OpenGL 3.3" true
MESA_GL_VERSION_OVERRIDE=2.1 REPLAN_GL=core "$program" "$scratch/world.json" >"$scratch/output" 2>&1 && fail "a core context came from nowhere"
grep -q "Cannot open a window" "$scratch/output" || fail "it does not say that there is no window"

echo "OpenGL ES shows what OpenGL core shows, and takes its place"
