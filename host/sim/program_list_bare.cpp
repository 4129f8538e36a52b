// SPDX-License-Identifier: MIT
//
// Stands in for program_list.cpp in a build without fonts, which all but the test cards need.
#include <host/sim/programs.hpp>

#include <array>

namespace host {

std::span<const Program> programs() {
  static const std::array all{primitives_program, testcard_program};
  return all;
}

}  // namespace host
