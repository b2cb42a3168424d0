# SPDX-License-Identifier: Apache-2.0
# An overlay port: vcpkg install ilot --overlay-ports=packaging/vcpkg. It builds the sources that it lies in.
get_filename_component(SOURCE_PATH "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)

vcpkg_cmake_configure(
  SOURCE_PATH "${SOURCE_PATH}"
  OPTIONS
    -DILOT_BUILD_TESTS=OFF
    -DILOT_JOIN_FILES=ON
)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(CONFIG_PATH lib/cmake/ilot)
vcpkg_fixup_pkgconfig()
vcpkg_copy_tools(TOOL_NAMES ilot AUTO_CLEAN)
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include" "${CURRENT_PACKAGES_DIR}/debug/share")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")
