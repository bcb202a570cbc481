# Shaders in the library: passes as SPIR-V, one array a permutation; host GLSL as text.
find_program(GLSLANG_VALIDATOR glslangValidator REQUIRED)
# Optimised SPIR-V makes pipelines faster to create. Some builds of glslang have no optimiser.
file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/optimises.comp "#version 450\nvoid main() {}\n")
execute_process(COMMAND ${GLSLANG_VALIDATOR} -V -Os -o optimises.spv optimises.comp
                WORKING_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}
                RESULT_VARIABLE AGAA_GLSLANG_FAILED OUTPUT_QUIET ERROR_QUIET)
if(AGAA_GLSLANG_FAILED)
  message(STATUS "${GLSLANG_VALIDATOR} does not optimise SPIR-V")
else()
  set(AGAA_GLSLANG_OPTIMISES -Os)
endif()
set(AGAA_EMBED_SCRIPT ${CMAKE_CURRENT_LIST_DIR}/embed_text.cmake)

# agaa_compile_pass(OUT_SPV FILE NAME DEFINES...): adds a command, appends the .spv to OUT_SPV.
function(agaa_compile_pass out_list file name)
  set(spv ${CMAKE_CURRENT_BINARY_DIR}/spirv/${name}.inc)
  set(shaders ${PROJECT_SOURCE_DIR}/src/shaders)
  file(MAKE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/spirv)
  # glslang names the files that the pass includes, so that a change compiles only what reads it.
  add_custom_command(
    OUTPUT ${spv}
    COMMAND ${GLSLANG_VALIDATOR} --quiet -V ${AGAA_GLSLANG_OPTIMISES} --target-env vulkan1.2 -I${shaders}
            -I${CMAKE_CURRENT_BINARY_DIR}/shaders ${ARGN} --vn spirv_${name} --depfile ${spv}.d -o ${spv}
            ${shaders}/${file}
    DEPENDS ${shaders}/${file} ${written_glsl}
    DEPFILE ${spv}.d
    COMMENT "Compiling ${name}" VERBATIM)
  set(${out_list} ${${out_list}} ${spv} PARENT_SCOPE)
endfunction()

# agaa_embed_text(OUTPUT BASE FILES...): a C++ include file of {"path", R"(text)"} rows.
function(agaa_embed_text output base)
  add_custom_command(
    OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} "-DOUTPUT=${output}" "-DBASE=${base}" "-DFILES=${ARGN}" -P
            ${AGAA_EMBED_SCRIPT}
    DEPENDS ${ARGN} ${AGAA_EMBED_SCRIPT}
    COMMENT "Embedding text" VERBATIM)
endfunction()
