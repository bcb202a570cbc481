# The shared library exports exactly the names of EXPECTED, one a line.
execute_process(COMMAND ${NM} -D --defined-only ${LIBRARY} OUTPUT_VARIABLE text
                RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "nm could not read ${LIBRARY}.")
endif()
string(REGEX MATCHALL " [TDBRVW] [A-Za-z_0-9.@]+" matches "${text}")
list(TRANSFORM matches REPLACE "^ . " "")
# Each has the version of the library that brought it; the name of a version is a symbol of its own.
list(FILTER matches EXCLUDE REGEX "^AGAA_[0-9.]+$")
list(TRANSFORM matches REPLACE "@@.*" "")
list(SORT matches)
file(STRINGS ${EXPECTED} expected)
list(SORT expected)
if(NOT matches STREQUAL expected)
  message(FATAL_ERROR "exported symbols differ.\nexported: ${matches}\nexpected: ${expected}")
endif()
list(LENGTH matches count)
message(STATUS "${count} exported symbols, as listed")
