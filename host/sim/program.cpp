// SPDX-License-Identifier: MIT
#include <host/sim/program.hpp>

#include <algorithm>

namespace host {

const Program* find_program(std::string_view name) {
  const auto found = std::ranges::find(programs(), name, &Program::name);
  return found == programs().end() ? nullptr : &*found;
}

}  // namespace host
