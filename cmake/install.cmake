# What is installed, in components: the tool, the module for STEP and IGES, the library (where it is shared), what compiling against it needs,
# and the Python package (python/CMakeLists.txt). CPack makes a package of each (cmake/packages.cmake).
include(CMakePackageConfigHelpers)
set(config ${CMAKE_INSTALL_LIBDIR}/cmake/dupin)

if(BUILD_SHARED_LIBS)
  install(TARGETS dupin EXPORT dupinTargets
    LIBRARY COMPONENT library NAMELINK_COMPONENT development)
  # It loads the module for STEP, which is beside it; the tool's own path does not count for what a library loads.
  dupin_runtime_path(dupin library ${CMAKE_INSTALL_LIBDIR} "$ORIGIN")
  foreach(room IN ITEMS kernel blends io)
    install(DIRECTORY ${room}/include/ TYPE INCLUDE COMPONENT development)
  endforeach()
  set(DUPIN_PC_LIBRARIES "-ldupin")
  set(DUPIN_PC_REQUIRES "")
else()
  install(TARGETS dupin dupin_kernel dupin_blends dupin_io EXPORT dupinTargets
    ARCHIVE COMPONENT development FILE_SET HEADERS COMPONENT development)
  set(DUPIN_PC_LIBRARIES "-ldupin_io -ldupin_blends -ldupin_kernel -lmpfi")
  set(DUPIN_PC_REQUIRES " mpfr tbb expat")
endif()
install(EXPORT dupinTargets NAMESPACE dupin:: DESTINATION ${config} COMPONENT development)
configure_package_config_file(cmake/dupinConfig.cmake.in ${PROJECT_BINARY_DIR}/dupinConfig.cmake
  INSTALL_DESTINATION ${config})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/dupinConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/dupinConfig.cmake ${PROJECT_BINARY_DIR}/dupinConfigVersion.cmake
  cmake/dupinDependencies.cmake DESTINATION ${config} COMPONENT development)

# For pkg-config. The prefix is that of the installation, known only then.
file(CONFIGURE OUTPUT dupin.pc.cmake @ONLY CONTENT [[
set(CMAKE_INSTALL_LIBDIR @CMAKE_INSTALL_LIBDIR@)
set(CMAKE_INSTALL_INCLUDEDIR @CMAKE_INSTALL_INCLUDEDIR@)
set(PROJECT_VERSION @PROJECT_VERSION@)
set(PROJECT_DESCRIPTION "@PROJECT_DESCRIPTION@")
set(DUPIN_PC_LIBRARIES "@DUPIN_PC_LIBRARIES@")
set(DUPIN_PC_REQUIRES "@DUPIN_PC_REQUIRES@")
configure_file("@PROJECT_SOURCE_DIR@/cmake/dupin.pc.in"
  "$ENV{DESTDIR}${CMAKE_INSTALL_PREFIX}/@CMAKE_INSTALL_LIBDIR@/pkgconfig/dupin.pc" @ONLY)
]])
install(SCRIPT ${CMAKE_CURRENT_BINARY_DIR}/dupin.pc.cmake COMPONENT development)

# Editors complete documents by these.
install(FILES io/assembly.schema.json io/certificate.schema.json DESTINATION ${CMAKE_INSTALL_DATADIR}/dupin
  COMPONENT tool)
