# "reference": the API pages (Doxygen, optional). Whatever it warns of is an error.
find_program(DUPIN_DOXYGEN doxygen)
mark_as_advanced(DUPIN_DOXYGEN)
if(DUPIN_DOXYGEN)
  configure_file(${PROJECT_SOURCE_DIR}/cmake/Doxyfile.in ${PROJECT_BINARY_DIR}/Doxyfile @ONLY)
  file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/reference)
  set(warnings ${PROJECT_BINARY_DIR}/reference/warnings.txt)
  # No semicolon: CMake would cut the command in two.
  set(make_reference sh -c "\"$1\" \"$2\" && ! grep . \"$3\"" sh
    ${DUPIN_DOXYGEN} ${PROJECT_BINARY_DIR}/Doxyfile ${warnings})
  add_custom_target(reference COMMAND ${make_reference} VERBATIM)
  if(DUPIN_BUILD_TESTS)
    add_test(NAME Reference.is_made_without_a_warning COMMAND ${make_reference})
  endif()
endif()
