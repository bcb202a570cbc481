# An overlay port, which builds the release archive that it lies in:
#   vcpkg install agaa --overlay-ports=packaging/vcpkg
cmake_path(SET SOURCE_PATH NORMALIZE ${CMAKE_CURRENT_LIST_DIR}/../../..)
if(NOT EXISTS ${SOURCE_PATH}/generated)
  message(FATAL_ERROR "${SOURCE_PATH} is no release archive: it has no generated files. scripts/release makes one.")
endif()
string(COMPARE EQUAL "${VCPKG_LIBRARY_LINKAGE}" static is_static)
vcpkg_cmake_configure(SOURCE_PATH ${SOURCE_PATH} OPTIONS -DAGAA_STATIC=${is_static})
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(CONFIG_PATH lib/cmake/agaa)
vcpkg_fixup_pkgconfig()
file(REMOVE_RECURSE ${CURRENT_PACKAGES_DIR}/debug/include ${CURRENT_PACKAGES_DIR}/debug/share)
vcpkg_install_copyright(FILE_LIST ${SOURCE_PATH}/LICENSE ${SOURCE_PATH}/NOTICES.md)
