# Installs the library, its headers, the package files for find_package and pkg-config, the documentation,
# the minimal hosts as examples, and the tools. Nothing installed names the prefix: it may be moved.
# The components runtime, development and tools are the Debian packages (scripts/package).
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

install(TARGETS agaa EXPORT agaa-targets
  RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT runtime
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT runtime NAMELINK_COMPONENT development
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development
  INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(FILES include/agaa_sdk.h include/agaa_vk.h include/agaa_gl.h
        include/agaa.hpp include/agaa_vk.hpp include/agaa_gl.hpp
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development)
install(DIRECTORY include/agaa DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development)

# The description of the ABI, and the bindings that are made of it.
install(FILES abi/agaa.json bindings/python/agaa.py bindings/csharp/Agaa.cs
  DESTINATION ${CMAKE_INSTALL_DATADIR}/agaa COMPONENT development)
install(DIRECTORY bindings/rust/agaa-sys DESTINATION ${CMAKE_INSTALL_DATADIR}/agaa COMPONENT development
  PATTERN target EXCLUDE PATTERN Cargo.lock EXCLUDE)

if(WIN32 AND NOT AGAA_STATIC)
  install(FILES ${CMAKE_LIBRARY_OUTPUT_DIRECTORY}/agaa.def DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
endif()

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/agaa)
install(EXPORT agaa-targets NAMESPACE agaa:: DESTINATION ${package_dir} COMPONENT development)
configure_package_config_file(cmake/agaa-config.cmake.in ${PROJECT_BINARY_DIR}/agaa-config.cmake
  INSTALL_DESTINATION ${package_dir} NO_SET_AND_CHECK_MACRO)
# While the major version is 0, every minor version may change the ABI.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/agaa-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/agaa-config.cmake ${PROJECT_BINARY_DIR}/agaa-config-version.cmake
  DESTINATION ${package_dir} COMPONENT development)

# From where agaa.pc lies; with absolute folders there is no way but to name them.
if(IS_ABSOLUTE ${CMAKE_INSTALL_LIBDIR} OR IS_ABSOLUTE ${CMAKE_INSTALL_INCLUDEDIR})
  set(pc_prefix ${CMAKE_INSTALL_PREFIX})
  set(pc_libdir ${CMAKE_INSTALL_FULL_LIBDIR})
  set(pc_includedir ${CMAKE_INSTALL_FULL_INCLUDEDIR})
else()
  cmake_path(RELATIVE_PATH CMAKE_INSTALL_PREFIX
             BASE_DIRECTORY ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig OUTPUT_VARIABLE to_prefix)
  set(pc_prefix "\${pcfiledir}/${to_prefix}")
  set(pc_libdir "\${prefix}/${CMAKE_INSTALL_LIBDIR}")
  set(pc_includedir "\${prefix}/${CMAKE_INSTALL_INCLUDEDIR}")
endif()
set(pc_static_libs "")
set(pc_static_flags "")
if(AGAA_STATIC)
  set(pc_static_flags " -DAGAA_STATIC")
  list(JOIN glslang_libraries " -l" pc_static_libs)
  string(PREPEND pc_static_libs " -l")
  string(APPEND pc_static_libs " -lzstd -lstdc++ -lm -lpthread")
endif()
configure_file(cmake/agaa.pc.in ${PROJECT_BINARY_DIR}/agaa.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/agaa.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT development)

# The README links to docs/, so the folder keeps its structure. Measured results stay in the source tree: they are
# large.
install(FILES LICENSE NOTICES.md README.md CHANGELOG.md CONTRIBUTING.md SECURITY.md
        DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT development)
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT development PATTERN results EXCLUDE)
install(DIRECTORY samples/minimal DESTINATION ${CMAKE_INSTALL_DOCDIR}/examples COMPONENT development)

if(AGAA_SAMPLES)
  # The program looks for the library beside it.
  set_target_properties(agaa-harness PROPERTIES INSTALL_RPATH "$ORIGIN/../${CMAKE_INSTALL_LIBDIR}")
  install(TARGETS agaa-harness RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT tools)
  install(FILES samples/harness/agaa-harness.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT tools)
  if(TARGET agaa-viewer)
    set_target_properties(agaa-viewer PROPERTIES INSTALL_RPATH "$ORIGIN/../${CMAKE_INSTALL_LIBDIR}")
    install(TARGETS agaa-viewer RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT tools)
    install(FILES samples/viewer/agaa-viewer.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT tools)
  endif()
endif()
