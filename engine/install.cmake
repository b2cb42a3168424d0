# SPDX-License-Identifier: Apache-2.0
# find_package(ilot) gives ilot::kernels and ilot::engine; headers as in the sources, below include/ilot/.
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/ilot)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/ilotConfig.cmake.in ${PROJECT_BINARY_DIR}/ilotConfig.cmake
  INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/ilotConfigVersion.cmake COMPATIBILITY SameMinorVersion)

install(TARGETS ilot_kernels ilot_engine EXPORT ilotTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(EXPORT ilotTargets NAMESPACE ilot:: DESTINATION ${package_dir})
install(FILES ${PROJECT_BINARY_DIR}/ilotConfig.cmake ${PROJECT_BINARY_DIR}/ilotConfigVersion.cmake
  DESTINATION ${package_dir})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/kernels ${PROJECT_SOURCE_DIR}/engine
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/ilot
  FILES_MATCHING PATTERN "*.h" PATTERN "kernels/simd" EXCLUDE)
