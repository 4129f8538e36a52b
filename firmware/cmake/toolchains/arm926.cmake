# SPDX-License-Identifier: MIT
set(INTAGLIO_CORE arm926)
set(INTAGLIO_CORE_FLAGS "-mcpu=arm926ej-s -marm")
include(${CMAKE_CURRENT_LIST_DIR}/arm-none-eabi.cmake)
