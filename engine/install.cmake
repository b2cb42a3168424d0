# SPDX-License-Identifier: Apache-2.0
# find_package(ilot) gives ilot::ilot: the headers of include/ilot and both libraries, which are also ilot::kernels and
# ilot::engine.
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/ilot)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/ilotConfig.cmake.in ${PROJECT_BINARY_DIR}/ilotConfig.cmake
  INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/ilotConfigVersion.cmake COMPATIBILITY SameMinorVersion)

add_library(ilot_public INTERFACE)
add_library(ilot::ilot ALIAS ilot_public)
set_target_properties(ilot_public PROPERTIES EXPORT_NAME ilot)
target_link_libraries(ilot_public INTERFACE ilot_engine)
install(TARGETS ilot_kernels ilot_engine ilot_public EXPORT ilotTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(EXPORT ilotTargets NAMESPACE ilot:: DESTINATION ${package_dir})
install(FILES ${PROJECT_BINARY_DIR}/ilotConfig.cmake ${PROJECT_BINARY_DIR}/ilotConfigVersion.cmake
  DESTINATION ${package_dir})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/ilot DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
  FILES_MATCHING PATTERN "*.h")
