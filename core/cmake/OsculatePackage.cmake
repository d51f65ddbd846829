# What find_package(osculate) reads: install with `cmake --install <build> --component development`.
include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/osculate)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/osculateConfig.cmake.in
  ${CMAKE_CURRENT_BINARY_DIR}/osculateConfig.cmake INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/osculateConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(EXPORT osculate NAMESPACE osculate:: FILE osculateTargets.cmake
  DESTINATION ${package_dir} COMPONENT development EXCLUDE_FROM_ALL)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/osculateConfig.cmake
  ${CMAKE_CURRENT_BINARY_DIR}/osculateConfigVersion.cmake
  DESTINATION ${package_dir} COMPONENT development EXCLUDE_FROM_ALL)
