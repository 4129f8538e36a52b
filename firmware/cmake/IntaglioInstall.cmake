# SPDX-License-Identifier: MIT
#
# `cmake --install` and `find_package(intaglio CONFIG)`.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(intaglio_config_dir ${CMAKE_INSTALL_LIBDIR}/cmake/intaglio)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/firmware/intaglio DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
        FILES_MATCHING PATTERN "*.hpp")
install(DIRECTORY ${PROJECT_SOURCE_DIR}/hal/include/hal DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
        FILES_MATCHING PATTERN "*.hpp")
install(DIRECTORY ${PROJECT_SOURCE_DIR}/hal/panels ${PROJECT_SOURCE_DIR}/hal/sim ${PROJECT_SOURCE_DIR}/hal/mock
                  ${PROJECT_SOURCE_DIR}/hal/hid
        DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/hal FILES_MATCHING PATTERN "*.hpp")

get_property(intaglio_exported GLOBAL PROPERTY intaglio_exported_targets)
install(TARGETS ${intaglio_exported} EXPORT intaglioTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(EXPORT intaglioTargets NAMESPACE intaglio:: DESTINATION ${intaglio_config_dir})
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/intaglioConfig.cmake.in
                              ${PROJECT_BINARY_DIR}/intaglioConfig.cmake
                              INSTALL_DESTINATION ${intaglio_config_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/intaglioConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/intaglioConfig.cmake ${PROJECT_BINARY_DIR}/intaglioConfigVersion.cmake
        DESTINATION ${intaglio_config_dir})
