// SPDX-License-Identifier: MIT
//
// Says in words why a frame tore, was late or was dropped: the chain of causes, each with its times.
#pragma once

#include <host/sim/timeline.hpp>

#include <string>
#include <vector>

namespace host {

/// A sentence of the whole run, then a paragraph for each frame that wasn't shown as it should be, up to
/// `most` of them.
[[nodiscard]] std::string explain(const Timeline& timeline, const std::vector<hal::sim::Tear>& tears,
                                  std::size_t most = 20);

}  // namespace host
