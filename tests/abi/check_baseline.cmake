# The library has the symbols and the soname of the baseline that scripts/abi-baseline wrote. abidiff filters most
# changes of types: tools/check_abi.py compares those, by the description that is frozen with the headers.
if(NOT ABIDIFF)
  message(STATUS "abidiff is not installed (package abigail-tools): the baseline is not compared.")
  return()
endif()
execute_process(COMMAND ${ABIDIFF} --headers-dir2 ${HEADERS} --no-added-syms ${BASELINE} ${LIBRARY}
                OUTPUT_VARIABLE report ERROR_VARIABLE report RESULT_VARIABLE status)
# Bits: 1 error, 2 usage, 4 a change, 8 an incompatible one.
math(EXPR refused "${status} & 11")
if(refused)
  message(FATAL_ERROR "The ABI is not that of ${BASELINE} (abidiff: ${status}).\n${report}")
endif()
message(STATUS "abidiff: ${status}\n${report}")
