# Optimises a SPIR-V module and writes it as an array of a C++ include file.
# Arguments: SPIRV_OPT, the program; PASSES, its list; INPUT, the module; OUTPUT; NAME, of the array.
execute_process(COMMAND ${SPIRV_OPT} ${PASSES} ${INPUT} -o ${INPUT}.optimised RESULT_VARIABLE failed
                OUTPUT_VARIABLE messages ERROR_VARIABLE messages) # it warns of each function that is not inlined
if(failed)
  message(FATAL_ERROR "${SPIRV_OPT} fails for ${INPUT}: ${messages}")
endif()
file(READ ${INPUT}.optimised bytes HEX)
file(REMOVE ${INPUT}.optimised)
string(REGEX REPLACE "(..)(..)(..)(..)" "0x\\4\\3\\2\\1," words "${bytes}") # little-endian
file(WRITE ${OUTPUT} "const uint32_t ${NAME}[] = {${words}};\n")
