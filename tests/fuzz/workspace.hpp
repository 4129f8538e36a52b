// SPDX-License-Identifier: MIT
//
// Memory that a call asks for.
#pragma once

#include <tests/fuzz/scene.hpp>

#include <span>
#include <vector>

namespace fuzz {

/// A workspace of exactly as many entries as the library asks for, so that a sanitizer sees each one beyond.
/// `draw(workspace)` answers a status; one entry less must be refused, and say so.
template <class Entry, class Draw>
std::vector<Entry> exact_workspace(Draw draw) {
  std::vector<Entry> workspace;
  const Status status = draw(std::span<Entry>(workspace));
  if (status.error() != intaglio::Error::too_small || status.argument() != intaglio::Argument::workspace)
    return workspace;
  require(status.needed() > 0, "a workspace of no entry is too small, but none is needed");
  workspace.resize(status.needed() - 1);
  require(draw(std::span<Entry>(workspace)) == status, "one entry less than needed isn't refused alike");
  workspace.resize(status.needed());
  return workspace;
}

}  // namespace fuzz
