# Writes the GLSL of src/shaders/tables/bindings.inc: a macro AGAA_BINDING_… for each binding of the SDK's compute passes.

# agaa_write_bindings(TABLE OUTPUT)
function(agaa_write_bindings table output)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${table})
  file(STRINGS ${table} rows REGEX "^AGAA_BINDING")
  set(opengl "")
  set(vulkan "")
  foreach(row IN LISTS rows)
    string(REGEX MATCH "\\(([A-Z0-9_]+), [A-Za-z0-9]+, ([0-9]+), [A-Za-z]+, ([0-9]+)\\)" matched "${row}")
    if(NOT matched)
      message(FATAL_ERROR "${table} has a row that is no binding: ${row}")
    endif()
    string(APPEND vulkan "#define AGAA_BINDING_${CMAKE_MATCH_1} set = 0, binding = ${CMAKE_MATCH_2}\n")
    string(APPEND opengl "#define AGAA_BINDING_${CMAKE_MATCH_1} binding = ${CMAKE_MATCH_3}\n")
  endforeach()
  file(CONFIGURE OUTPUT ${output} @ONLY CONTENT
       "#ifndef AGAA_BINDINGS_GLSL\n#define AGAA_BINDINGS_GLSL\n#ifdef AGAA_GL\n${opengl}#else\n${vulkan}#endif\n#endif\n")
endfunction()
