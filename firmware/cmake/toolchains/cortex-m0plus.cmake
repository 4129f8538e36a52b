# SPDX-License-Identifier: MIT
set(INTAGLIO_CORE cortex-m0plus)
set(INTAGLIO_CORE_FLAGS "-mcpu=cortex-m0plus -mthumb")
include(${CMAKE_CURRENT_LIST_DIR}/arm-none-eabi.cmake)
