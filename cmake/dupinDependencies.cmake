# What the library is linked with, found alike by its own build and by whoever uses what was installed
# (dupinConfig.cmake includes this file). Libraries without reliable CMake files of their own become targets
# dupin_external::NAME; what is missing is said with Debian's package, before anything is compiled.

# dupin_library(NAME HEADER PACKAGE)
function(dupin_library name header package)
  if(TARGET dupin_external::${name})
    return()
  endif()
  find_library(DUPIN_LIBRARY_${name} NAMES ${name})
  find_path(DUPIN_HEADERS_${name} NAMES ${header})
  mark_as_advanced(DUPIN_LIBRARY_${name} DUPIN_HEADERS_${name})
  if(NOT DUPIN_LIBRARY_${name} OR NOT DUPIN_HEADERS_${name})
    set_property(GLOBAL APPEND PROPERTY DUPIN_MISSING "${name} (Debian: ${package})")
    return()
  endif()
  add_library(dupin_external::${name} UNKNOWN IMPORTED GLOBAL)
  set_target_properties(dupin_external::${name} PROPERTIES
    IMPORTED_LOCATION ${DUPIN_LIBRARY_${name}}
    INTERFACE_INCLUDE_DIRECTORIES ${DUPIN_HEADERS_${name}})
endfunction()

# The numbers in public headers.
macro(dupin_find_public_libraries)
  dupin_library(gmp gmp.h libgmp-dev)
  dupin_library(gmpxx gmpxx.h libgmp-dev)
endmacro()

# What static libraries leave to be linked.
macro(dupin_find_private_libraries)
  dupin_library(mpfr mpfr.h libmpfr-dev)
  dupin_library(mpfi mpfi.h libmpfi-dev)
  dupin_library(expat expat.h libexpat1-dev)
endmacro()

# dupin_missing_libraries(VARIABLE): a sentence about them, or nothing.
function(dupin_missing_libraries variable)
  get_property(missing GLOBAL PROPERTY DUPIN_MISSING)
  list(REMOVE_DUPLICATES missing)
  list(JOIN missing ", " missing)
  if(missing)
    set(missing "dupin needs libraries with their headers that are not there: ${missing}")
  endif()
  set(${variable} "${missing}" PARENT_SCOPE)
endfunction()
