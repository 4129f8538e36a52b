// SPDX-License-Identifier: MIT
#include <host/sim/programs.hpp>

#include <array>

namespace host {

std::span<const Program> programs() {
  static const std::array all{gauges_program, map_program, primitives_program, testcard_program};
  return all;
}

}  // namespace host
