// SPDX-License-Identifier: MIT
//
// How many samples a test takes: a few at the desk, all of them in the full run.
#pragma once

#include <cstdlib>
#include <string_view>

namespace oracle {

/// True if the environment says INTAGLIO_FULL=1, as `tests/run` does for the optimised build. Sanitized
/// builds and `tests/run --quick` leave it out.
inline bool full_run() {
  const char* const wish = std::getenv("INTAGLIO_FULL");
  return wish != nullptr && std::string_view(wish) == "1";
}

/// `quick` samples, or `full` of them in the full run.
template <class T>
T samples(T quick, T full) {
  return full_run() ? full : quick;
}

}  // namespace oracle
