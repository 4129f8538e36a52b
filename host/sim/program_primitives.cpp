// SPDX-License-Identifier: MIT
#include <host/sim/programs.hpp>

#include <firmware/apps/primitives/primitives.hpp>

namespace host {

constexpr Program primitives_program{"primitives",
                                     "every primitive of the library, each in a field of its own",
                                     run_on_panel<apps::primitives::Primitives>};

}  // namespace host
