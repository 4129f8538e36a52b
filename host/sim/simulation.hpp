// SPDX-License-Identifier: MIT
//
// One run of the simulator: a program, a panel, someone who looks on, and files that stay.
#pragma once

#include <host/sim/options.hpp>
#include <host/sim/program.hpp>

#include <iosfwd>

namespace host {

/// Writes the names of programs, panels and effects.
void list_all(std::ostream& out);

/// Writes what real panels and buses there are.
void list_panels(std::ostream& out);

/// Runs what the options ask for. Throws Failure with a text for the user if that can't be done.
void simulate(const Options& options);

/// Runs what the options ask for on a real panel, in real time, until its frames are shown or the user ends
/// it. Throws Failure.
void run_on_real_panel(const Options& options);

/// VBLANKs a frame at the frame rate that the options ask for, at least one.
[[nodiscard]] int interval_of(const Options& options, const hal::Capabilities& panel);

/// How frames follow each other on any panel. Throws Failure where late ones can't be dropped.
[[nodiscard]] intaglio::present::Pace pace_of(const Options& options, const hal::Capabilities& panel);

/// The program that the options name. Throws Failure.
[[nodiscard]] const Program& program_of(const Options& options);

}  // namespace host
