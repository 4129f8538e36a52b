// SPDX-License-Identifier: MIT
//
// Stands in for window.cpp in a build without SDL2.
#include <host/failure.hpp>
#include <host/sim/viewer.hpp>

namespace host {

bool window_possible() { return false; }

std::unique_ptr<Viewer> open_window(const std::string& /*title*/, int /*width*/, int /*height*/,
                                    int /*scale*/) {
  throw Failure("--window: this build has no windows (SDL2 was missing when it was configured)");
}

}  // namespace host
