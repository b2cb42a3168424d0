# SPDX-License-Identifier: Apache-2.0
# What goes into the pages that ilot writes: the style and the scripts of this folder and, where npm has installed what
# package-lock.json names (tools/setup does), the viewer with three.js. No download: what is missing is left out, and
# the pages say so. Sets ILOT_PAGE_PARTS, a source file of the library.
set(viewer_dir ${CMAKE_CURRENT_LIST_DIR})
set(ILOT_VIEWER AUTO CACHE STRING "The 3D viewer in reports: ON (needs tools/setup with npm), OFF, or AUTO")
set_property(CACHE ILOT_VIEWER PROPERTY STRINGS AUTO ON OFF)
find_program(ILOT_NODE node)
set(ILOT_PAGE_PARTS ${CMAKE_CURRENT_BINARY_DIR}/page_parts_content.cpp)
set(viewer_bundle ${CMAKE_CURRENT_BINARY_DIR}/viewer.js)
set(viewer_page_files data.js units.js tables.js plan.js start.js)
list(TRANSFORM viewer_page_files PREPEND ${viewer_dir}/page/)

set(viewer_missing "")
if(ILOT_VIEWER STREQUAL "OFF")
  set(viewer_missing "ILOT_VIEWER is OFF")
elseif(NOT ILOT_NODE)
  set(viewer_missing "there is no node")
elseif(NOT EXISTS ${viewer_dir}/node_modules/esbuild/package.json OR NOT EXISTS ${viewer_dir}/node_modules/three/package.json)
  set(viewer_missing "viewer/node_modules is missing: tools/setup installs it where there is npm")
endif()
if(viewer_missing AND ILOT_VIEWER STREQUAL "ON")
  message(FATAL_ERROR "ILOT_VIEWER is ON, but ${viewer_missing}")
elseif(viewer_missing)
  message(STATUS "Reports will have no view in 3D: ${viewer_missing}")
  file(WRITE ${viewer_bundle} "")
else()
  file(GLOB viewer_sources CONFIGURE_DEPENDS ${viewer_dir}/src/*.js)
  add_custom_command(OUTPUT ${viewer_bundle}
    COMMAND ${ILOT_NODE} ${viewer_dir}/bundle.mjs ${viewer_bundle}
    DEPENDS ${viewer_sources} ${viewer_dir}/bundle.mjs ${viewer_dir}/package-lock.json
    COMMENT "Bundling the viewer" VERBATIM)
endif()
add_custom_command(OUTPUT ${ILOT_PAGE_PARTS}
  COMMAND ${CMAKE_COMMAND} -DOUTPUT=${ILOT_PAGE_PARTS} -DSTYLE=${viewer_dir}/page/style.css
    "-DPAGE=${viewer_page_files}" -DVIEWER=${viewer_bundle} -P ${viewer_dir}/embed.cmake
  DEPENDS ${viewer_bundle} ${viewer_page_files} ${viewer_dir}/page/style.css ${viewer_dir}/embed.cmake
  COMMENT "Embedding the pages' parts" VERBATIM)
