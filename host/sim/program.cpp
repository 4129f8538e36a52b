// SPDX-License-Identifier: MIT
#include <host/sim/program.hpp>
#include <host/sim/programs.hpp>

#include <algorithm>
#include <array>

namespace host {

std::span<const Program> programs() {
  static const std::array all{testcard_program};
  return all;
}

const Program* find_program(std::string_view name) {
  const auto found = std::ranges::find(programs(), name, &Program::name);
  return found == programs().end() ? nullptr : &*found;
}

}  // namespace host
