// SPDX-License-Identifier: MIT
//
// A timeline as a trace-event file, which chrome://tracing and Perfetto open.
//
// Rule: one track each for drawing, presenting, the bus, scan-out, VBLANK and deadlines. Slices of a track
// don't overlap, events are in the order of their times, and times are exact: microseconds with three
// decimals.
#pragma once

#include <host/sim/timeline.hpp>

#include <string>

namespace host {

/// The text of the file.
[[nodiscard]] std::string trace(const Timeline& timeline, const std::vector<hal::sim::Tear>& tears);

}  // namespace host
