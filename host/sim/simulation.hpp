// SPDX-License-Identifier: MIT
//
// One run of the simulator: a program, a panel, someone who looks on, and files that stay.
#pragma once

#include <host/sim/options.hpp>

#include <iosfwd>

namespace host {

/// Writes the names of programs, panels and effects.
void list_all(std::ostream& out);

/// Runs what the options ask for. Throws Failure with a text for the user if that can't be done.
void simulate(const Options& options);

}  // namespace host
