// SPDX-License-Identifier: MIT
//
// Says in words why a frame tore, was late or was dropped: the chain of causes, each with its times.
#pragma once

#include <host/sim/timeline.hpp>

#include <string>
#include <vector>

namespace host {

/// As in "10 shown, 2 of them late; 1 dropped; 3 refreshes showed the frame before again".
[[nodiscard]] std::string to_text(const intaglio::present::FrameCounts& counts);

/// A sentence of the whole run, its counts if there are any, then a paragraph for each frame that wasn't
/// shown as it should be, or for several alike in succession, up to `most` of them.
[[nodiscard]] std::string explain(const Timeline& timeline, const std::vector<hal::sim::Tear>& tears,
                                  std::size_t most = 20);

}  // namespace host
