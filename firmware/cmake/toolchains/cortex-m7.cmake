# SPDX-License-Identifier: MIT
set(INTAGLIO_CORE cortex-m7)
set(INTAGLIO_CORE_FLAGS "-mcpu=cortex-m7 -mthumb -mfloat-abi=soft")
include(${CMAKE_CURRENT_LIST_DIR}/arm-none-eabi.cmake)
