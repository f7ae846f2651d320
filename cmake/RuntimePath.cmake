# dupin_runtime_path(TARGET COMPONENT DESTINATION [PATH]), behind its install(TARGETS): in the build tree it finds modules
# and the shared library where they are made; once installed, at PATH, or where the system looks if there is none.
#
# CMake changes such paths when it installs, too, but ends that of the build tree by a separator. What is behind that, the
# loader takes for the working directory, and anybody's libraries there for ours. So CMake is told that nothing changes,
# and what its own scripts do is done here; slashes make room for a path that is longer.
function(dupin_runtime_path target component destination)
  if(NOT CMAKE_EXECUTABLE_FORMAT STREQUAL "ELF")
    set_target_properties(${target} PROPERTIES INSTALL_RPATH "${ARGN}")
    return()
  endif()
  set(built ${CMAKE_BUILD_RPATH})
  if(BUILD_SHARED_LIBS)
    list(PREPEND built ${PROJECT_BINARY_DIR})
  endif()
  list(JOIN built ":" built)
  string(LENGTH "${built}" length)
  string(LENGTH "${ARGN}" least)
  while(length LESS least)
    string(APPEND built "/")
    math(EXPR length "${length} + 1")
  endwhile()
  set_target_properties(${target} PROPERTIES BUILD_WITH_INSTALL_RPATH ON INSTALL_RPATH "${built}"
    INSTALL_RPATH_USE_LINK_PATH ON)
  if(NOT IS_ABSOLUTE "${destination}")
    string(PREPEND destination "\${CMAKE_INSTALL_PREFIX}/")
  endif()
  set(file "\$ENV{DESTDIR}${destination}/$<TARGET_FILE_NAME:${target}>")
  if(ARGN)
    string(REPLACE "$" "\\$" installed "${ARGN}")
    install(CODE "file(RPATH_SET FILE \"${file}\" NEW_RPATH \"${installed}\")" COMPONENT ${component})
  else()
    install(CODE "file(RPATH_REMOVE FILE \"${file}\")" COMPONENT ${component})
  endif()
endfunction()
