# What `cmake --install` and `cpack` put in place. The program finds its scripts from its own place, and the package
# file its libraries from its own, so that the whole may be moved.
set(libraries ${rooms})
list(TRANSFORM libraries PREPEND ricochet_)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/ricochet)
set(data_dir ${CMAKE_INSTALL_DATADIR}/ricochet)

install(TARGETS ricochet COMPONENT program)
install(DIRECTORY scripts prm meshes DESTINATION ${data_dir} COMPONENT program
  PATTERN __pycache__ EXCLUDE)
install(FILES ${PROJECT_BINARY_DIR}/share/ricochet/plotly.js.gz DESTINATION ${data_dir} COMPONENT program OPTIONAL)
install(FILES README.md CHANGELOG.md LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)
install(DIRECTORY doc/ DESTINATION ${CMAKE_INSTALL_DOCDIR}/doc COMPONENT program)

install(TARGETS ${libraries} dealii trilinos EXPORT ricochet_targets ARCHIVE COMPONENT development)
install(DIRECTORY include/ricochet DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development)
install(EXPORT ricochet_targets NAMESPACE ricochet:: FILE ricochet-targets.cmake DESTINATION ${package_dir}
  COMPONENT development)
include(CMakePackageConfigHelpers)
configure_package_config_file(source/ricochet-config.cmake.in ${PROJECT_BINARY_DIR}/ricochet-config.cmake
  INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/ricochet-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/ricochet-config.cmake ${PROJECT_BINARY_DIR}/ricochet-config-version.cmake
  DESTINATION ${package_dir} COMPONENT development)

# cpack -G DEB: ricochet to run, ricochet-dev to build upon it. -D CPACK_DEBIAN_PACKAGE_MAINTAINER names who packs it.
set(CPACK_PACKAGE_VENDOR "the ricochet developers")
set(CPACK_PACKAGE_CONTACT "the ricochet developers <ricochet@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "simulates oblique impact, ricochet and penetration")
set(CPACK_PACKAGE_DESCRIPTION "Peridynamics near the impact, explicit finite elements elsewhere, contact with friction.
 Runs parameter files on one core or many, alone or over grids of values.")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL program development)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME ricochet)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS openmpi-bin)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "python3-matplotlib, python3-h5py, python3-plotly") # without them no pictures
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME ricochet-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libdeal.ii-dev, libopenmpi-dev, libhdf5-openmpi-dev, libeigen3-dev, \
libnanoflann-dev, nlohmann-json3-dev")
include(CPack)
