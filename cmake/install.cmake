include(CMakePackageConfigHelpers)
install(TARGETS dupin dupin_kernel dupin_blends dupin_io EXPORT dupinTargets FILE_SET HEADERS)
install(EXPORT dupinTargets NAMESPACE dupin:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/dupin)
configure_package_config_file(cmake/dupinConfig.cmake.in ${PROJECT_BINARY_DIR}/dupinConfig.cmake
  INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/dupin)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/dupinConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/dupinConfig.cmake ${PROJECT_BINARY_DIR}/dupinConfigVersion.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/dupin)
