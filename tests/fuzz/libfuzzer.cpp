// SPDX-License-Identifier: MIT
//
// A fuzz target as libFuzzer calls it.
#include <tests/fuzz/input.hpp>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::run(fuzz::Input({data, size}));
  return 0;
}
