# SPDX-License-Identifier: MIT
#
# Font tables made at build time, in native and in cross builds alike.
include(ExternalProject)

# intaglio_assets_command(RESULT DEPENDS): how to call the asset compiler, and what to depend on. A cross build
# first builds it natively (in native-tools/ of its build folder), unless INTAGLIO_ASSETS names one.
function(intaglio_assets_command result depends)
  set(INTAGLIO_ASSETS "" CACHE FILEPATH "An intaglio-assets to use instead of building one")
  if(INTAGLIO_ASSETS)
    set(${result} ${INTAGLIO_ASSETS} PARENT_SCOPE)
    set(${depends} ${INTAGLIO_ASSETS} PARENT_SCOPE)
  elseif(CMAKE_CROSSCOMPILING)
    set(folder ${intaglio_BINARY_DIR}/native-tools)
    if(NOT TARGET intaglio_native_tools)
      ExternalProject_Add(
        intaglio_native_tools
        SOURCE_DIR ${intaglio_SOURCE_DIR}
        BINARY_DIR ${folder}
        PREFIX ${folder}/external
        CMAKE_ARGS -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS_RELEASE=-O2\ -DNDEBUG -DINTAGLIO_BUILD_TESTS=OFF
                   -DINTAGLIO_BUILD_FONTS=OFF -DINTAGLIO_INSTALL=OFF -DINTAGLIO_BUILD_HOST=OFF
                   -DINTAGLIO_NATIVE_TOOLS=ON
        BUILD_COMMAND ${CMAKE_COMMAND} --build ${folder} --target intaglio-assets
        BUILD_ALWAYS ON
        BUILD_BYPRODUCTS ${folder}/bin/intaglio-assets
        INSTALL_COMMAND ""
        EXCLUDE_FROM_ALL ON)
    endif()
    set(${result} ${folder}/bin/intaglio-assets PARENT_SCOPE)
    set(${depends} intaglio_native_tools ${folder}/bin/intaglio-assets PARENT_SCOPE)
  else()
    set(${result} $<TARGET_FILE:intaglio-assets> PARENT_SCOPE)
    set(${depends} intaglio-assets PARENT_SCOPE)
  endif()
endfunction()

# intaglio_add_font(TARGET NAME FILE [ARGUMENTS...]): <intaglio_fonts/NAME.hpp> with the font intaglio::fonts::NAME
# from FILE, for those who link TARGET, an INTERFACE library. ARGUMENTS are those of `intaglio-assets font`.
function(intaglio_add_font target name file)
  intaglio_assets_command(assets assets_depends)
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/include)
  set(header ${folder}/intaglio_fonts/${name}.hpp)
  file(MAKE_DIRECTORY ${folder}/intaglio_fonts)
  add_custom_command(
    OUTPUT ${header}
    COMMAND ${assets} font ${file} --name ${name} -o ${header} ${ARGN}
    DEPENDS ${file} ${assets_depends}
    COMMENT "Font table ${name}"
    VERBATIM)
  add_custom_target(${target}_${name} ALL DEPENDS ${header})
  add_dependencies(${target} ${target}_${name})
  target_include_directories(${target} INTERFACE $<BUILD_INTERFACE:${folder}>)
endfunction()
