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

}  // namespace lab::frames
