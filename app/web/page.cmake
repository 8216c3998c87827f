# The page for browsers (scripts/web.sh): the same program on a canvas. What opens windows, draws without one and writes
# films for the desktop has its counterpart in this folder.
file(GLOB WEB_SOURCES CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/*.cpp)
file(GLOB APP_SOURCES CONFIGURE_DEPENDS *.cpp platform/window.cpp)
list(FILTER APP_SOURCES EXCLUDE REGEX "/(main|gui)\\.cpp$")
add_executable(replan_page ${APP_SOURCES} ${WEB_SOURCES})
replan_target(replan_page)
target_compile_definitions(replan_page PRIVATE REPLAN_VERSION="${PROJECT_VERSION}")
target_link_libraries(replan_page PRIVATE replan_ui nlohmann_json::nlohmann_json idbfs.js)
batch_by_room(replan_page ${APP_SOURCES} ${WEB_SOURCES})
set_target_properties(replan_page PROPERTIES OUTPUT_NAME replan RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR})

# Files under the paths where the program looks for them. The fonts are those of the desktop, but for the one of Chinese,
# which is larger than all the rest.
set(EMBEDDED "${PROJECT_SOURCE_DIR}/assets@/replan/assets" "${PROJECT_SOURCE_DIR}/maps@/replan/maps")
foreach(font opentype/inter/Inter-Regular.otf opentype/inter/Inter-SemiBold.otf
    truetype/jetbrains-mono/JetBrainsMono-Regular.ttf truetype/jetbrains-mono/JetBrainsMono-SemiBold.ttf
    opentype/font-awesome/FontAwesome.otf)
  list(APPEND EMBEDDED "/usr/share/fonts/${font}@/usr/share/fonts/${font}")
endforeach()
list(TRANSFORM EMBEDDED PREPEND "SHELL:--embed-file ")
set(PAGE_SCRIPT "${CMAKE_CURRENT_LIST_DIR}/page.js")
target_link_options(replan_page PRIVATE ${EMBEDDED} "SHELL:--pre-js ${PAGE_SCRIPT}" -O2
  -sALLOW_MEMORY_GROWTH=1 -sINITIAL_MEMORY=67108864 -sMAXIMUM_MEMORY=2147483648 -sTOTAL_STACK=1048576
  -sMIN_WEBGL_VERSION=2 -sMAX_WEBGL_VERSION=2 -sENVIRONMENT=web -sFORCE_FILESYSTEM=1 -sABORTING_MALLOC=0 -sFS_DEBUG=1
  "-sEXPORTED_FUNCTIONS=['_main','_malloc','_free']" "-sINCOMING_MODULE_JS_API=['canvas','preRun','setStatus','onAbort','wasmBinary']")
set_target_properties(replan_page PROPERTIES LINK_DEPENDS "${PAGE_SCRIPT}")
configure_file(${CMAKE_CURRENT_LIST_DIR}/index.html ${PROJECT_BINARY_DIR}/index.html COPYONLY)

# The same logs as on the desktop: tests/web/logs_test.sh.
add_executable(replan_log_hashes ${PROJECT_SOURCE_DIR}/tests/web/log_hashes.cpp)
replan_target(replan_log_hashes)
target_link_libraries(replan_log_hashes PRIVATE replan_core)
target_link_options(replan_log_hashes PRIVATE -O1 -sNODERAWFS=1 -sENVIRONMENT=node -sALLOW_MEMORY_GROWTH=1
  -sMAXIMUM_MEMORY=2147483648)
set_target_properties(replan_log_hashes PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR})
