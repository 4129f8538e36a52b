// SPDX-License-Identifier: MIT
//
// The scenes, each in its own file, for each is a program.
#pragma once

#include <firmware/lab/frames/scene.hpp>

namespace lab::frames {

[[nodiscard]] Scene gauges() noexcept;
[[nodiscard]] Scene map() noexcept;
[[nodiscard]] Scene primitives() noexcept;
[[nodiscard]] Scene testcard() noexcept;

/// Programs with their knobs as constants.
[[nodiscard]] Program gauges_as_it_is() noexcept;
[[nodiscard]] Program gauges_finest() noexcept;
[[nodiscard]] Program map_as_it_is() noexcept;

}  // namespace lab::frames
