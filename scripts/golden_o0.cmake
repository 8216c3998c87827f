# The golden logs' test with the sources that it needs, and nothing else: what the preset golden-o0 builds, so that a
# build without optimisation costs seconds. CMake includes this file at the end of project(), see CMakePresets.json.
find_package(GTest REQUIRED)
file(GLOB PLANNING_SOURCES CONFIGURE_DEPENDS
  core/base/*.cpp core/field/*.cpp core/lattice/*.cpp core/plan/*.cpp core/planners/*.cpp
  core/trace/*.cpp)
list(FILTER PLANNING_SOURCES EXCLUDE REGEX "/(stb|pages)\\.cpp$")
add_executable(replan_golden_o0 EXCLUDE_FROM_ALL ${PLANNING_SOURCES} tests/unit/golden_log_test.cpp)
target_link_libraries(replan_golden_o0 PRIVATE replan_flags GTest::gtest_main)
target_compile_definitions(replan_golden_o0 PRIVATE REPLAN_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
set_target_properties(replan_golden_o0 PROPERTIES CXX_STANDARD 20 CXX_STANDARD_REQUIRED ON CXX_EXTENSIONS OFF)
