// SPDX-License-Identifier: MIT
//
// Statuses in words, for tools, logs and tests. Costs about a kilobyte of text where it is used, nothing
// elsewhere.
#pragma once

#include <intaglio/status.hpp>

namespace intaglio {

/// The name of an error, as in "out of domain". Never null.
[[nodiscard]] const char* to_text(Error error) noexcept;
/// The name of an argument, as in "radius". Never null.
[[nodiscard]] const char* to_text(Argument argument) noexcept;

}  // namespace intaglio
