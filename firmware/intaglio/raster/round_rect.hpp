// SPDX-License-Identifier: MIT
//
// Rectangles with round corners.
//
// Rule: the pixels of the rectangle, but in each corner's square of r by r pixels those of the disc of radius
// r (disc.hpp) around the pixel that is r columns and r rows from the corner. Radius 0 leaves the corner. The
// outline is what of it has a neighbour outside (row_shape.hpp).
//
// Radii that don't fit are made smaller, as CSS does: where the radii at a side's two ends sum up to more
// than the distance between its end pixels (length - 1), all four are multiplied by the smallest of the four
// ratios of distance and sum, and rounded down. A single radius so becomes at most (shorter side - 1) / 2.
//
// Only visible rows are visited. Bit budget: sides and sums of radii have 22 bits, products 44. Error: none.
// Textbook: section 2.4. Worst known inputs: 3x10 with r = 2, 30x9 with r = 5 (others wrap or write outside).
#pragma once

#include <intaglio/linear/rect.hpp>
#include <intaglio/raster/oval.hpp>
#include <intaglio/raster/row_shape.hpp>
#include <intaglio/raster/row_span.hpp>
#include <intaglio/raster/sink.hpp>
#include <intaglio/status.hpp>

namespace intaglio::raster {

/// The radii of a rectangle's corners, 0..2^20 pixels each, clockwise from the top left.
struct CornerRadii {
  int top_left = 0;
  int top_right = 0;
  int bottom_right = 0;
  int bottom_left = 0;

  /// Four times the same.
  [[nodiscard]] static constexpr CornerRadii all(int radius) noexcept {
    return {radius, radius, radius, radius};
  }
  friend constexpr bool operator==(const CornerRadii&, const CornerRadii&) noexcept = default;
};

namespace detail {

/// Errors: out_of_domain rectangle, radius.
[[nodiscard]] Status check_round_rect(const linear::Rect& r, const CornerRadii& radii) noexcept;
/// The radii that fit. Precondition: as checked, and the rectangle has a pixel.
[[nodiscard]] CornerRadii fitting(const linear::Rect& r, const CornerRadii& radii) noexcept;

/// A rectangle with round corners, row by row.
class RoundRectShape {
 public:
  /// Precondition: the rectangle has a pixel, the radii are `fitting`.
  RoundRectShape(const linear::Rect& r, const CornerRadii& radii) noexcept;

  [[nodiscard]] RowSpan row(int y) noexcept;
  void look_at(int x_begin, int x_end) noexcept {
    left_.look_at(x_begin - 2 - rect_.x, x_end + 1 - rect_.x);
    right_.look_at(rect_.right() - x_end - 2, rect_.right() - x_begin + 1);
  }
  [[nodiscard]] int top() const noexcept { return rect_.y; }
  [[nodiscard]] int bottom() const noexcept { return rect_.bottom(); }

 private:
  /// What a side is moved in by the disc of the upper or lower corner.
  class Side {
   public:
    Side(int upper_radius, int lower_radius) noexcept
        : upper_radius_(upper_radius),
          lower_radius_(lower_radius),
          upper_(Oval::around({}, upper_radius, upper_radius)),
          lower_(Oval::around({}, lower_radius, lower_radius)) {}
    /// Only insets from `low` to `high` matter from now on.
    void look_at(int low, int high) noexcept {
      upper_.look_at({2 * upper_radius_, low, high});
      lower_.look_at({2 * lower_radius_, low, high});
    }
    [[nodiscard]] int inset(int from_top, int from_bottom) noexcept {
      if (from_top < upper_radius_) return upper_.inset(from_top);
      return from_bottom < lower_radius_ ? lower_.inset(from_bottom) : 0;
    }

   private:
    int upper_radius_;
    int lower_radius_;
    Oval upper_;
    Oval lower_;
  };

  linear::Rect rect_;
  Side left_;
  Side right_;
};

}  // namespace detail

/// Fills a rectangle (`linear::in_domain`) with round corners; an empty one has no pixel.
/// Errors: out_of_domain rectangle, radius; nothing is drawn then. Cost: on rows that cross corners as of
/// `fill_ellipse`.
template <SpanSink S>
Status fill_round_rect(S&& sink, const linear::Rect& r, const CornerRadii& radii) {
  const Status status = detail::check_round_rect(r, radii);
  if (status.ok() && !r.empty())
    detail::fill_rows(sink, detail::RoundRectShape(r, detail::fitting(r, radii)));
  return status;
}

/// Draws the outline of what `fill_round_rect` fills. Errors and cost as there.
template <SpanSink S>
Status draw_round_rect(S&& sink, const linear::Rect& r, const CornerRadii& radii) {
  const Status status = detail::check_round_rect(r, radii);
  if (status.ok() && !r.empty())
    detail::outline_rows(sink, detail::RoundRectShape(r, detail::fitting(r, radii)));
  return status;
}

}  // namespace intaglio::raster
