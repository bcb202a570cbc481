# Writes OUTPUT, a header with AGAA_BUILD_NAME: VERSION, and the commit of SOURCE where it is a checkout. Run by every
# build; the file is touched where the name changed only.
set(name ${VERSION})
find_program(GIT git)
if(GIT AND EXISTS ${SOURCE}/.git)
  execute_process(COMMAND ${GIT} -C ${SOURCE} describe --always --dirty --abbrev=10 --match=
                  OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  if(commit)
    string(APPEND name "-${commit}")
  endif()
endif()
set(text "#define AGAA_BUILD_NAME \"${name}\"\n")
set(old "")
if(EXISTS ${OUTPUT})
  file(READ ${OUTPUT} old)
endif()
if(NOT text STREQUAL old)
  file(WRITE ${OUTPUT} "${text}")
endif()
