// SPDX-License-Identifier: MIT
//
// A stack of clip rectangles for nested drawing: a window in a window in a screen.
//
// Rule: `top()` is what all the rectangles pushed have in common with the bounds, never more. A sink takes it
// as its clip: `raster::Solid sink{surface, index, clips.top()}`. The stack is a value: to give a part of a
// picture its own, copy it.
//
// Bit budget: as linear::intersect. Memory: 16 bytes a level. Textbook: section 2.9.1, for any primitive.
// Worst known input: rectangles of negative extent, which hold nothing.
#pragma once

#include <intaglio/linear/rect.hpp>
#include <intaglio/status.hpp>

#include <array>
#include <cstddef>

namespace intaglio::clip {

/// Up to `Levels` rectangles, each inside the one before.
template <int Levels>
class ClipStack {
  static_assert(Levels > 0 && Levels < 1024);

 public:
  /// Nothing pushed: `top()` is `bounds`, those of the surface, say. Bounds outside the domain hold nothing.
  constexpr explicit ClipStack(const linear::Rect& bounds) noexcept {
    if (linear::in_domain(bounds)) areas_[0] = linear::intersect(bounds, bounds);
  }

  /// Where can be drawn: a rectangle in the domain, its extents not negative.
  [[nodiscard]] constexpr const linear::Rect& top() const noexcept {
    return areas_[static_cast<std::size_t>(depth_)];
  }
  /// How many rectangles are pushed.
  [[nodiscard]] constexpr int depth() const noexcept { return depth_; }

  /// Clips to `area`, too. Errors: rectangle (out_of_domain), count (too_large: there are `needed()` pushed
  /// and there is room for no more); nothing changes then.
  constexpr Status push(const linear::Rect& area) noexcept {
    if (!linear::in_domain(area)) return {Error::out_of_domain, Argument::rectangle};
    if (depth_ == Levels) return {Error::too_large, Argument::count, Levels};
    const linear::Rect common = linear::intersect(top(), area);
    areas_[static_cast<std::size_t>(++depth_)] = common;
    return {};
  }

  /// Takes the last rectangle back. Errors: count (empty: none is pushed); nothing changes then.
  constexpr Status pop() noexcept {
    if (depth_ == 0) return {Error::empty, Argument::count};
    --depth_;
    return {};
  }

 private:
  std::array<linear::Rect, static_cast<std::size_t>(Levels) + 1>
      areas_{};  // the bounds, and after each push what is left
  int depth_ = 0;
};

}  // namespace intaglio::clip
