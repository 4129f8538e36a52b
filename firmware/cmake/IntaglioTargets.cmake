# SPDX-License-Identifier: MIT
#
# How targets are made here: warnings, the freestanding rules, and the summary printed after configuring.

# intaglio_compile_quickly(SOURCES...): leaves these unoptimised: what takes long to optimise and is quick anyhow.
function(intaglio_compile_quickly)
  set_source_files_properties(${ARGN} PROPERTIES COMPILE_OPTIONS -O0)
endfunction()

# intaglio_own(TARGET): our own code: C++20 and strict warnings.
function(intaglio_own target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wconversion -Wsign-conversion -Wshadow)
  if(INTAGLIO_WARNINGS_AS_ERRORS)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
endfunction()

# intaglio_freestanding(TARGET): code for the device: no exceptions, no RTTI, no static guards, a section a
# function, so that the linker drops what a program doesn't call.
function(intaglio_freestanding target)
  intaglio_own(${target})
  target_compile_options(${target} PRIVATE -ffreestanding -fno-exceptions -fno-rtti -fno-threadsafe-statics
                                           -ffunction-sections -fdata-sections)
endfunction()

# intaglio_feature(NAME STATE WHY): a line of the configure summary. No semicolons: they part CMake's lists.
function(intaglio_feature name state why)
  if(state) # also the path of what was found
    set(state ON)
  else()
    set(state OFF)
  endif()
  set_property(GLOBAL APPEND PROPERTY intaglio_features "${name}: ${state} (${why})")
endfunction()

function(intaglio_print_summary)
  message(STATUS "Intaglio ${PROJECT_VERSION}: what is on and off")
  get_property(features GLOBAL PROPERTY intaglio_features)
  foreach(feature IN LISTS features)
    message(STATUS "  ${feature}")
  endforeach()
endfunction()
