# SPDX-License-Identifier: MIT
#
# GCC for bare-metal RISC-V. Debian's compiler comes without C++ headers; they are the same libstdc++ as the
# Arm compiler's (equal GCC version), so these are borrowed, with picolibc's C headers beneath.
# ISA specification 2.2 counts the CSR instructions among rv32i's; a march that names them (_zicsr) finds none
# of the compiler's libraries.
set(INTAGLIO_CORE rv32imac)
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR riscv32)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
set(CMAKE_ASM_COMPILER riscv64-unknown-elf-gcc)
set(CMAKE_CXX_COMPILER riscv64-unknown-elf-g++)
file(GLOB intaglio_libstdcxx LIST_DIRECTORIES true /usr/lib/arm-none-eabi/include/c++/*)
list(GET intaglio_libstdcxx 0 intaglio_libstdcxx)
set(CMAKE_CXX_FLAGS_INIT "-march=rv32imac -misa-spec=2.2 -mabi=ilp32 -mcmodel=medany --specs=picolibc.specs -nostdinc++ \
-isystem ${intaglio_libstdcxx} -isystem ${intaglio_libstdcxx}/arm-none-eabi/thumb/v7-m/nofp")
set(CMAKE_ASM_FLAGS_INIT "-march=rv32imac -misa-spec=2.2 -mabi=ilp32 -mcmodel=medany")
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
