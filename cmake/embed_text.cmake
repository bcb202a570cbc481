# Writes OUTPUT: one row {"relative path", R"AGAA(text)AGAA"}, per file. FILES may hold semicolons.
set(text "")
foreach(file IN LISTS FILES)
  file(READ ${file} content)
  file(RELATIVE_PATH name ${BASE} ${file})
  string(APPEND text "{\"${name}\", R\"AGAA(${content})AGAA\"},\n")
endforeach()
file(WRITE ${OUTPUT} "${text}")
