# Run as a script: writes a C++ source with functions that return the texts of files.
#   cmake -D OUTPUT=out.cpp -D HEADER=page_files.h ... -P EmbedFiles.cmake
# VERSION is a text; PAGE, STYLE, SCRIPT (several, joined with "|"), LICENCE and LIBRARY are the paths; LIBRARY may be empty.

# One raw string is at most 65536 characters for compilers that keep to the letter; pieces are joined.
function(piece_of content result)
  set(pieces "")
  string(LENGTH "${content}" length)
  set(begin 0)
  while(begin LESS length)
    string(SUBSTRING "${content}" ${begin} 15000 piece)
    string(APPEND pieces "R\"~~~(${piece})~~~\"\n")
    math(EXPR begin "${begin} + 15000")
  endwhile()
  if(pieces STREQUAL "")
    set(pieces "\"\"\n")
  endif()
  set(${result} "${pieces}" PARENT_SCOPE)
endfunction()

function(text_of paths result)
  set(all "")
  string(REPLACE "|" ";" paths "${paths}")
  foreach(path IN LISTS paths)
    file(READ "${path}" content)
    string(APPEND all "${content}")
  endforeach()
  piece_of("${all}" pieces)
  set(${result} "${pieces}" PARENT_SCOPE)
endfunction()

set(source "// Made by cmake/EmbedFiles.cmake.\n#include \"pages/page_files.h\"\n\nnamespace dupin::pages {\n
PageFiles page_files() {\n  PageFiles files;\n  files.version = \"${VERSION}\";\n")
foreach(entry IN ITEMS PAGE:page STYLE:style SCRIPT:script LIBRARY:library LICENCE:library_licence)
  string(REPLACE ":" ";" entry "${entry}")
  list(GET entry 0 variable)
  list(GET entry 1 member)
  text_of("${${variable}}" pieces)
  string(APPEND source "  files.${member} =\n${pieces};\n")
endforeach()
string(APPEND source "  return files;\n}\n\n}  // namespace dupin::pages\n")
file(WRITE "${OUTPUT}" "${source}")
