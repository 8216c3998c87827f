# What find_package(replan) finds in another project, and add_subdirectory() calls by the same names: replan::plan and
# replan::core. Each is exported by itself, so that who only plans needs none of core's packages.
include(CMakePackageConfigHelpers)
set(REPLAN_CONFIG_FOLDER "${CMAKE_INSTALL_LIBDIR}/cmake/replan")

# install_library(TARGET NAME ROOM...): the library, and the headers of its rooms.
function(install_library target name)
  add_library(replan::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  if(NOT REPLAN_INSTALL)
    return()
  endif()
  install(TARGETS ${target} EXPORT replan-${name} ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}")
  install(EXPORT replan-${name} NAMESPACE replan:: DESTINATION "${REPLAN_CONFIG_FOLDER}")
  install(DIRECTORY ${ARGN} DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/replan/core"
    FILES_MATCHING PATTERN "*.hpp" PATTERN "*.def")
endfunction()

if(REPLAN_INSTALL)
  configure_package_config_file(replan-config.cmake.in "${CMAKE_CURRENT_BINARY_DIR}/replan-config.cmake"
    INSTALL_DESTINATION "${REPLAN_CONFIG_FOLDER}" NO_SET_AND_CHECK_MACRO)
  # Before 1.0 a minor version may break what was there.
  write_basic_package_version_file("${CMAKE_CURRENT_BINARY_DIR}/replan-config-version.cmake"
    COMPATIBILITY SameMinorVersion)
  install(FILES "${CMAKE_CURRENT_BINARY_DIR}/replan-config.cmake"
    "${CMAKE_CURRENT_BINARY_DIR}/replan-config-version.cmake" DESTINATION "${REPLAN_CONFIG_FOLDER}")
endif()
