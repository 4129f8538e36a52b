# SPDX-License-Identifier: MIT
#
# `cmake --install`, `find_package(intaglio CONFIG)`, `pkg-config intaglio`, and `cpack`, which makes the Debian
# packages intaglio-tools (component tools: the programs) and libintaglio-dev (component dev: headers, libraries).
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(intaglio_config_dir ${CMAKE_INSTALL_LIBDIR}/cmake/intaglio)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/firmware/intaglio DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT dev
        FILES_MATCHING PATTERN "*.hpp")
install(DIRECTORY ${PROJECT_SOURCE_DIR}/hal/include/hal DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT dev
        FILES_MATCHING PATTERN "*.hpp")
# Headers go where their libraries go.
set(intaglio_hal_folders panels hid)
foreach(room sim mock linux)
  if(TARGET intaglio_${room})
    list(APPEND intaglio_hal_folders ${room})
  endif()
endforeach()
foreach(room IN LISTS intaglio_hal_folders)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/hal/${room} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/hal COMPONENT dev
          FILES_MATCHING PATTERN "*.hpp" PATTERN "pictures" EXCLUDE)
endforeach()

get_property(intaglio_exported GLOBAL PROPERTY intaglio_exported_targets)
install(TARGETS ${intaglio_exported} EXPORT intaglioTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT dev)
install(EXPORT intaglioTargets NAMESPACE intaglio:: DESTINATION ${intaglio_config_dir} COMPONENT dev)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/intaglioConfig.cmake.in
                              ${PROJECT_BINARY_DIR}/intaglioConfig.cmake
                              INSTALL_DESTINATION ${intaglio_config_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/intaglioConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/intaglioConfig.cmake ${PROJECT_BINARY_DIR}/intaglioConfigVersion.cmake
        DESTINATION ${intaglio_config_dir} COMPONENT dev)

# intaglio_pkg_config(NAME DESCRIPTION REQUIRES LIBS)
function(intaglio_pkg_config name description requires libs)
  set(folder ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
  file(RELATIVE_PATH INTAGLIO_PC_PREFIX /p/${folder} /p)
  string(REGEX REPLACE "/$" "" INTAGLIO_PC_PREFIX "${INTAGLIO_PC_PREFIX}")
  set(INTAGLIO_PC_NAME ${name})
  set(INTAGLIO_PC_DESCRIPTION ${description})
  set(INTAGLIO_PC_REQUIRES ${requires})
  set(INTAGLIO_PC_LIBS ${libs})
  configure_file(${CMAKE_CURRENT_FUNCTION_LIST_DIR}/intaglio.pc.in ${PROJECT_BINARY_DIR}/${name}.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/${name}.pc DESTINATION ${folder} COMPONENT dev)
endfunction()
intaglio_pkg_config(intaglio "${PROJECT_DESCRIPTION}" "" "-lintaglio_core -lintaglio_hal")
if(TARGET intaglio_sim)
  intaglio_pkg_config(intaglio-sim "Simulated panels for Intaglio" intaglio "-lintaglio_sim")
endif()
if(TARGET intaglio_mock)
  intaglio_pkg_config(intaglio-mock "Test doubles of panels for Intaglio" "intaglio gmock" "-lintaglio_mock")
endif()

if(TARGET intaglio_linux)
  set(requires intaglio)
  if(INTAGLIO_GPIOD_VERSION)
    string(APPEND requires " libgpiod")
  endif()
  if(INTAGLIO_WITH_KMS)
    string(APPEND requires " libdrm")
  endif()
  intaglio_pkg_config(intaglio-linux "Panels of Linux boards for Intaglio" "${requires}" "-lintaglio_linux")
endif()
if(TARGET intaglio_hid)
  intaglio_pkg_config(intaglio-hid "Displays on USB HID for Intaglio" intaglio "-lintaglio_hid")
endif()

if(NOT intaglio_native_top OR NOT INTAGLIO_BUILD_HOST)
  return()
endif()

foreach(program intaglio-sim intaglio-draw intaglio-assets)
  if(TARGET ${program})
    install(TARGETS ${program} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT tools)
  endif()
endforeach()
install(FILES ${PROJECT_SOURCE_DIR}/hal/linux/70-intaglio.rules DESTINATION lib/udev/rules.d COMPONENT tools)
set(intaglio_doc_dir ${CMAKE_INSTALL_DATAROOTDIR}/doc)
foreach(package tools/intaglio-tools dev/libintaglio-dev)
  get_filename_component(component ${package} DIRECTORY)
  get_filename_component(name ${package} NAME)
  install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${intaglio_doc_dir}/${name} COMPONENT ${component}
          RENAME copyright)
endforeach()
install(FILES ${PROJECT_SOURCE_DIR}/hal/linux/WIRING.md DESTINATION ${intaglio_doc_dir}/intaglio-tools COMPONENT tools)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/hal/linux/pictures DESTINATION ${intaglio_doc_dir}/intaglio-tools
        COMPONENT tools FILES_MATCHING PATTERN "*.png")

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME intaglio)
set(CPACK_PACKAGE_VENDOR "The Intaglio developers")
set(CPACK_PACKAGE_CONTACT "The Intaglio developers <intaglio@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/packages)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL tools dev)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_TOOLS_PACKAGE_NAME intaglio-tools)
set(CPACK_DEBIAN_TOOLS_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_TOOLS_PACKAGE_RECOMMENDS "libhidapi-hidraw0, libhidapi-libusb0") # loaded when they are wanted
set(CPACK_DEBIAN_TOOLS_DESCRIPTION "Simulator, drawing tool and asset compiler for small displays
Draws on simulated panels, on real ones behind Linux GPIO, SPI, I2C or USB HID,
and into PNG files, with integers only and the same pixels everywhere.")
set(CPACK_DEBIAN_DEV_PACKAGE_NAME libintaglio-dev)
set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEV_PACKAGE_DEPENDS "libstdc++-12-dev | libstdc++-dev")
set(CPACK_DEBIAN_DEV_PACKAGE_SUGGESTS "libgmock-dev, libgpiod-dev, libdrm-dev, intaglio-tools")
set(CPACK_DEBIAN_DEV_DESCRIPTION "Integer-only 2D graphics for small displays (development files)
A C++20 library that draws on indexed framebuffers, bare metal or on Linux,
with drivers for display controllers, simulated panels and test doubles.")
include(CPack)
