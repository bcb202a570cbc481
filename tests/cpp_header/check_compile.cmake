# Compiles each C++ header alone, and use.cpp, as C++17 and C++20, with Microsoft's extensions off and on, without
# exceptions and RTTI, and with every warning an error. CXX is the compiler, HEADERS the folder, USE the file.
if(NOT CXX)
  message(STATUS "clang++ is not installed")
  return()
endif()
function(compile)
  execute_process(COMMAND ${CXX} -fno-exceptions -fno-rtti -pedantic-errors -Wall -Wextra -Wpedantic -Wconversion
                  -Wsign-conversion -Wshadow -Wold-style-cast -Wzero-as-null-pointer-constant -Werror -I${HEADERS}
                  ${ARGN} RESULT_VARIABLE result ERROR_VARIABLE messages)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${CXX} ${ARGN} fails:\n${messages}")
  endif()
endfunction()
foreach(header agaa agaa_vk agaa_gl)
  compile(-std=c++17 -fno-ms-extensions -fsyntax-only -include ${header}.hpp -x c++ /dev/null)
  compile(-std=c++20 -fms-extensions -fsyntax-only -include ${header}.hpp -x c++ /dev/null)
endforeach()
compile(-std=c++17 -fms-extensions -c -o /dev/null ${USE})
compile(-std=c++20 -fno-ms-extensions -c -o /dev/null ${USE})
