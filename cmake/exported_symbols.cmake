# Writes a version script that exports the names of the public namespace and hides all others. Called with
# -D archives=a.a,b.a -D modules=arrangement,booleans -D nm=nm -D output=file.
#
# dupin:: holds what public headers declare; modules have namespaces of their own in it (docs/architecture.md). So no
# header needs macros, and nothing is exported by being forgotten.
cmake_minimum_required(VERSION 3.25)
string(REPLACE "," ";" archives "${archives}")
string(REPLACE "," ";" modules "${modules}")
execute_process(COMMAND ${nm} -g --defined-only --format=posix ${archives}
  OUTPUT_VARIABLE listed COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "(^|\n)_Z(T[ISV]|GV)?NK?[RO]?5dupin[^ \n]*" names "${listed}")
list(TRANSFORM names STRIP)
foreach(module IN LISTS modules)
  string(LENGTH ${module} length)
  list(FILTER names EXCLUDE REGEX "^_Z(T[ISV]|GV)?NK?[RO]?5dupin${length}${module}")
endforeach()
list(FILTER names EXCLUDE REGEX "5dupin12_GLOBAL__N_1")
list(REMOVE_DUPLICATES names)
list(SORT names)
if(NOT names)
  message(FATAL_ERROR "no public names in ${archives}")
endif()
list(JOIN names ";\n    " names)
file(WRITE ${output} "{\n  global:\n    ${names};\n  local:\n    *;\n};\n")
