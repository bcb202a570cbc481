# Shaders in the library: passes as compressed SPIR-V, one array a permutation.
# These passes make pipelines up to nine times faster to create. glslang's own list (-Os) also merges returns and
# simplifies, for which GPUs need more registers (docs/results/compiled.md).
set(AGAA_SPIRV_PASSES --inline-entry-points-exhaustive --eliminate-dead-functions --scalar-replacement=100
    --convert-local-access-chains --eliminate-local-single-block --eliminate-local-single-store --ssa-rewrite
    --eliminate-dead-code-aggressive --strip-debug)

# agaa_compile_pass(OUT_LIST FILE NAME:MACRO=VALUE:…...): adds commands that compile permutations of a pass, and appends
# the include files of their arrays to OUT_LIST.
function(agaa_compile_pass out_list file)
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/spirv)
  set(shaders ${PROJECT_SOURCE_DIR}/src/shaders)
  file(MAKE_DIRECTORY ${folder})
  list(JOIN AGAA_SPIRV_PASSES , optimisations)
  list(LENGTH ARGN count)
  math(EXPR last "${count} - 1")
  # Permutations of one process are compressed by their differences; several processes compile at the same time.
  foreach(begin RANGE 0 ${last} 24)
    list(SUBLIST ARGN ${begin} 24 permutations)
    string(REGEX REPLACE ":[^;]*" "" names "${permutations}")
    list(GET names 0 first)
    list(TRANSFORM names REPLACE "(.+)" "${folder}/\\1.inc" OUTPUT_VARIABLE arrays)
    # The program names the files that the pass includes, so that a change compiles only what reads it.
    add_custom_command(
      OUTPUT ${arrays}
      COMMAND agaa-compile-passes ${shaders}/${file} ${folder} ${folder}/${first}.d
              ${shaders},${CMAKE_CURRENT_BINARY_DIR}/shaders ${optimisations} ${permutations}
      DEPENDS agaa-compile-passes ${shaders}/${file} ${written_glsl}
      DEPFILE ${folder}/${first}.d
      COMMENT "Compiling ${first} and further permutations" VERBATIM)
    list(APPEND ${out_list} ${arrays})
  endforeach()
  set(${out_list} ${${out_list}} PARENT_SCOPE)
endfunction()
