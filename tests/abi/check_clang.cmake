# Compiles each public header alone with Clang, as each standard: the sources that tests/abi/CMakeLists.txt writes into
# SOURCES for the build's own compiler.
if(NOT CLANG)
  message(STATUS "clang is not installed")
  return()
endif()
list(TRANSFORM HEADERS PREPEND -I OUTPUT_VARIABLE includes)
file(GLOB sources ${SOURCES}/agaa_*_c*.c ${SOURCES}/agaa_*_c*.cpp)
list(LENGTH sources count)
if(NOT count EQUAL 32)
  message(FATAL_ERROR "${SOURCES} has ${count} sources where 32 are expected.")
endif()
foreach(source ${sources})
  string(REGEX REPLACE ".*_(c[^_]*)\\.c(pp)?$" "\\1" standard ${source})
  string(REPLACE "c++23" "c++2b" standard ${standard}) # its name before Clang 17
  execute_process(COMMAND ${CLANG} -std=${standard} -fsyntax-only -pedantic-errors -Wall -Wextra -Wpadded -Werror
                  ${includes} ${source} RESULT_VARIABLE result ERROR_VARIABLE messages)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "Clang refuses ${source}:\n${messages}")
  endif()
endforeach()
