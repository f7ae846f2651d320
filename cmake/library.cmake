# dupin::dupin, what users link: the three rooms' archives or, with BUILD_SHARED_LIBS, one shared library of all their
# objects.
if(NOT BUILD_SHARED_LIBS)
  add_library(dupin INTERFACE)
  target_link_libraries(dupin INTERFACE dupin_kernel dupin_blends dupin_io)
else()
  file(GLOB modules CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR} kernel/src/* blends/src/* io/src/*)
  list(TRANSFORM modules REPLACE ".*/" "")
  list(JOIN modules "," modules)
  set(exported ${PROJECT_BINARY_DIR}/exported_symbols.map)
  add_custom_command(OUTPUT ${exported}
    COMMAND ${CMAKE_COMMAND} -D nm=${CMAKE_NM} -D modules=${modules} -D output=${exported}
      -D archives=$<TARGET_FILE:dupin_kernel>,$<TARGET_FILE:dupin_blends>,$<TARGET_FILE:dupin_io>
      -P ${PROJECT_SOURCE_DIR}/cmake/exported_symbols.cmake
    DEPENDS cmake/exported_symbols.cmake dupin_kernel dupin_blends dupin_io VERBATIM)
  file(CONFIGURE OUTPUT library.cpp CONTENT "")
  add_library(dupin SHARED ${PROJECT_BINARY_DIR}/library.cpp ${exported}
    $<TARGET_OBJECTS:dupin_kernel> $<TARGET_OBJECTS:dupin_blends> $<TARGET_OBJECTS:dupin_io>)
  # The archives add nothing to their own objects but what these are linked with.
  target_link_libraries(dupin PUBLIC Eigen3::Eigen dupin_external::gmpxx dupin_external::gmp
    PRIVATE dupin_kernel dupin_blends dupin_io)
  target_compile_features(dupin PUBLIC cxx_std_20)
  foreach(room IN ITEMS kernel blends io)
    target_include_directories(dupin INTERFACE $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/${room}/include>)
  endforeach()
  target_include_directories(dupin INTERFACE $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  # Before 1.0 every minor version may change what is exported.
  set_target_properties(dupin PROPERTIES VERSION ${PROJECT_VERSION}
    SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR} LINK_DEPENDS ${exported})
  target_link_options(dupin PRIVATE LINKER:--version-script=${exported} LINKER:-z,defs)
endif()
add_library(dupin::dupin ALIAS dupin)
