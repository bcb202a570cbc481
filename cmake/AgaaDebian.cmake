# Writes debian/ into the build folder, from which scripts/package makes the Debian packages.
set(debian ${PROJECT_BINARY_DIR}/debian)
set(AGAA_SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
# Honours SOURCE_DATE_EPOCH, so that the same sources give the same packages.
string(TIMESTAMP AGAA_DATE "%a, %d %b %Y %H:%M:%S +0000" UTC)

foreach(file changelog control copyright libagaa.symbols libagaa-dev.lintian-overrides rules)
  string(REPLACE "libagaa." "libagaa${AGAA_SOVERSION}." output ${file})
  configure_file(packaging/debian/${file}.in ${debian}/${output} @ONLY)
endforeach()
file(CHMOD ${debian}/rules PERMISSIONS
     OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)

# The licences of the project and of all that is compiled into its binaries (NOTICES.md).
file(READ LICENSE licence)
file(APPEND ${debian}/copyright "${licence}")
set(compiled_in glslang-dev spirv-tools libzstd-dev python3-glad nlohmann-json3-dev libcli11-dev libglm-dev)
if(TARGET agaa-viewer)
  list(APPEND compiled_in libimgui-dev)
endif()
foreach(package ${compiled_in})
  set(notice /usr/share/doc/${package}/copyright)
  if(NOT EXISTS ${notice})
    message(FATAL_ERROR
            "${notice}, whose code is in the packages, is missing; scripts/install-deps installs ${package}.")
  endif()
  file(READ ${notice} text)
  file(APPEND ${debian}/copyright "\n\n==== ${package} ====\n\n${text}")
endforeach()
file(READ benchmark/report/vendor/img-comparison-slider.LICENSE text)
file(APPEND ${debian}/copyright "\n\n==== img-comparison-slider ====\n\n${text}")
