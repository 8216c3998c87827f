# The golden logs' test and the planners that it needs, and nothing else: what the preset golden-o0 builds, so that a
# build without optimisation costs seconds. CMake includes this file at the end of project(), see CMakePresets.json.
find_package(GTest REQUIRED)
add_executable(replan_golden_o0 EXCLUDE_FROM_ALL tests/planner/golden_log_test.cpp)
target_link_libraries(replan_golden_o0 PRIVATE replan_plan GTest::gtest_main)
target_compile_definitions(replan_golden_o0 PRIVATE REPLAN_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
set_target_properties(replan_golden_o0 PROPERTIES CXX_EXTENSIONS OFF)
