# Windows x64 by MinGW-w64 of Debian, with threads of POSIX, which the C++ library needs. The packages of the target are
# below AGAA_WINDOWS_PREFIX (scripts/windows).
set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR x86_64)
set(CMAKE_C_COMPILER x86_64-w64-mingw32-gcc-posix)
set(CMAKE_CXX_COMPILER x86_64-w64-mingw32-g++-posix)
set(CMAKE_RC_COMPILER x86_64-w64-mingw32-windres)
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES AGAA_WINDOWS_PREFIX)
set(CMAKE_FIND_ROOT_PATH ${AGAA_WINDOWS_PREFIX} /usr/x86_64-w64-mingw32)
set(CMAKE_PREFIX_PATH /)
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
# The programs need no DLL of the compiler. Big objects have more sections than COFF's old format counts.
set(CMAKE_EXE_LINKER_FLAGS_INIT -static)
set(CMAKE_C_FLAGS_INIT -Wa,-mbig-obj)
set(CMAKE_CXX_FLAGS_INIT -Wa,-mbig-obj)
set(ZLIB_USE_STATIC_LIBS ON)
