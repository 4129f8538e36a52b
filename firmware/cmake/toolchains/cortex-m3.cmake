# SPDX-License-Identifier: MIT
set(INTAGLIO_CORE cortex-m3)
set(INTAGLIO_CORE_FLAGS "-mcpu=cortex-m3 -mthumb")
include(${CMAKE_CURRENT_LIST_DIR}/arm-none-eabi.cmake)
