// SPDX-License-Identifier: MIT
#include <host/sim/programs.hpp>

#include <firmware/apps/testcard/testcard.hpp>

namespace host {

constexpr Program testcard_program{"testcard", "a test card that shows what is wrong with a panel",
                                   run_on_panel<apps::testcard::TestCard>};

}  // namespace host
