# Shaders in the library: passes as SPIR-V, one array a permutation; host GLSL as text.
find_program(GLSLANG_VALIDATOR glslangValidator REQUIRED)
find_program(SPIRV_OPT spirv-opt REQUIRED)
# These passes make pipelines up to nine times faster to create. glslang's own list (-Os) also merges returns and
# simplifies, for which GPUs need more registers (docs/results/compiled.md).
set(AGAA_SPIRV_PASSES --inline-entry-points-exhaustive --eliminate-dead-functions --scalar-replacement=100
    --convert-local-access-chains --eliminate-local-single-block --eliminate-local-single-store --ssa-rewrite
    --eliminate-dead-code-aggressive)
set(AGAA_EMBED_SCRIPT ${CMAKE_CURRENT_LIST_DIR}/embed_text.cmake)
set(AGAA_EMBED_SPIRV_SCRIPT ${CMAKE_CURRENT_LIST_DIR}/embed_spirv.cmake)

# agaa_compile_pass(OUT_LIST FILE NAME DEFINES...): adds commands, appends the include file of the array to OUT_LIST.
function(agaa_compile_pass out_list file name)
  set(spv ${CMAKE_CURRENT_BINARY_DIR}/spirv/${name}.spv)
  set(array ${CMAKE_CURRENT_BINARY_DIR}/spirv/${name}.inc)
  set(shaders ${PROJECT_SOURCE_DIR}/src/shaders)
  file(MAKE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/spirv)
  # glslang names the files that the pass includes, so that a change compiles only what reads it.
  add_custom_command(
    OUTPUT ${spv}
    COMMAND ${GLSLANG_VALIDATOR} --quiet -V --target-env vulkan1.2 -I${shaders}
            -I${CMAKE_CURRENT_BINARY_DIR}/shaders ${ARGN} --depfile ${spv}.d -o ${spv} ${shaders}/${file}
    DEPENDS ${shaders}/${file} ${written_glsl}
    DEPFILE ${spv}.d
    COMMENT "Compiling ${name}" VERBATIM)
  add_custom_command(
    OUTPUT ${array}
    COMMAND ${CMAKE_COMMAND} -D SPIRV_OPT=${SPIRV_OPT} "-DPASSES=${AGAA_SPIRV_PASSES}" -D INPUT=${spv}
            -D OUTPUT=${array} -D NAME=spirv_${name} -P ${AGAA_EMBED_SPIRV_SCRIPT}
    DEPENDS ${spv} ${AGAA_EMBED_SPIRV_SCRIPT}
    COMMENT "Optimising ${name}" VERBATIM)
  set(${out_list} ${${out_list}} ${array} PARENT_SCOPE)
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
