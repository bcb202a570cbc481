# The shaders in the library. Sets embedded_folder, whose files core/base/embedded.cpp includes, and embedded_files.
if(AGAA_GENERATED)
  set(embedded_folder ${AGAA_GENERATED})
  file(GLOB embedded_files ${AGAA_GENERATED}/*.inc ${AGAA_GENERATED}/spirv/*.inc)
  if(NOT embedded_files)
    message(FATAL_ERROR "AGAA_GENERATED is ${AGAA_GENERATED}, which has no generated files of the SDK.")
  endif()
  return()
endif()
include(AgaaShaders)
include(AgaaPermutations)
include(AgaaBindings)
set(embedded_folder ${CMAKE_CURRENT_BINARY_DIR})

# GLSL that is written by the build.
set(written_glsl ${CMAKE_CURRENT_BINARY_DIR}/shaders/common/bindings.glsl)
agaa_write_bindings(${CMAKE_CURRENT_SOURCE_DIR}/shaders/tables/bindings.inc ${written_glsl})

add_executable(agaa-compile-passes compile_passes/main.cpp compile_passes/encode.cpp core/base/spirv_code.cpp)
target_include_directories(agaa-compile-passes PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
target_link_libraries(agaa-compile-passes
  PRIVATE glslang::glslang glslang::SPIRV glslang::glslang-default-resource-limits SPIRV-Tools-opt
          zstd::libzstd_static)
add_executable(agaa-embed-text compile_passes/embed_text.cpp)
target_link_libraries(agaa-embed-text PRIVATE zstd::libzstd_static)
foreach(program agaa-compile-passes agaa-embed-text) # the build runs them
  target_compile_options(${program} PRIVATE -fno-sanitize=all)
  target_link_options(${program} PRIVATE -fno-sanitize=all)
endforeach()
agaa_compile_permutations(${CMAKE_CURRENT_SOURCE_DIR}/shaders/tables/permutations.inc embedded_files spirv_names)
set(spirv_includes "")
set(spirv_table "")
foreach(name IN LISTS spirv_names)
  string(APPEND spirv_includes "#include \"spirv/${name}.inc\"\n")
  string(APPEND spirv_table "&module_${name},\n")
endforeach()
file(CONFIGURE OUTPUT spirv_includes.inc CONTENT "${spirv_includes}")
file(CONFIGURE OUTPUT spirv_table.inc CONTENT "${spirv_table}")

file(GLOB_RECURSE shader_texts CONFIGURE_DEPENDS
     ${CMAKE_CURRENT_SOURCE_DIR}/shaders/*.comp ${CMAKE_CURRENT_SOURCE_DIR}/shaders/*.glsl
     ${CMAKE_CURRENT_SOURCE_DIR}/shaders/*.inc)
add_custom_command(
  OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/shader_texts.inc
  COMMAND agaa-embed-text ${CMAKE_CURRENT_BINARY_DIR}/shader_texts.inc
          ${CMAKE_CURRENT_SOURCE_DIR}/shaders,${CMAKE_CURRENT_BINARY_DIR}/shaders ${shader_texts} ${written_glsl}
  DEPENDS agaa-embed-text ${shader_texts} ${written_glsl}
  COMMENT "Compressing texts of shaders" VERBATIM)
list(APPEND embedded_files ${CMAKE_CURRENT_BINARY_DIR}/shader_texts.inc)
