// SPDX-License-Identifier: MIT
//
// What blits share that look up, for pixels of the target, which pixel of the source they show.
//
// Rule: such a blit reads the source in an order of its own, so the memory that it may write to must not meet
// that of the source or of the rule's mask; else it is refused. Pixels outside the target's bounds or outside
// the clip stay as they are. Error: none. Textbook: none.
#pragma once

#include <intaglio/image/blit.hpp>
#include <intaglio/image/overlap.hpp>
#include <intaglio/image/surface.hpp>
#include <intaglio/linear/point.hpp>
#include <intaglio/linear/rect.hpp>
#include <intaglio/status.hpp>

namespace intaglio::image {

/// The longest side of a source that is shown turned.
inline constexpr int turned_side_limit = 1 << 16;

namespace detail {

/// True if a source may be turned about its place `pivot`, which lands on `position`. Errors: position, point
/// (each outside the domain of sub-pixels), too_large source (a side above `turned_side_limit`).
[[nodiscard]] constexpr Status check_turned(linear::SubPoint position, linear::SubPoint pivot,
                                            linear::Size source) noexcept {
  if (!linear::in_domain(position)) return {Error::out_of_domain, Argument::position};
  if (!linear::in_domain(pivot)) return {Error::out_of_domain, Argument::point};
  if (source.width > turned_side_limit || source.height > turned_side_limit)
    return {Error::too_large, Argument::source, turned_side_limit};
  return {};
}

/// Calls show_part(part, show) with the part of `destination` to be drawn, where show(x, y, column, row)
/// shows on pixel (x, y) of the target the pixel `column`, `row` of the source, counted from its corner; not
/// if nothing is visible or the source is empty. Errors: rectangle (the clip is outside the domain), colour,
/// table, mask (as `blit`), mismatched source (its memory meets that of the part). Flattened, for with a call
/// a pixel the views would have to stay in memory.
template <PixelFormat F, PixelFormat G, class Byte, class Rule, class ShowPart>
[[gnu::flatten]] Status blit_by_lookup(const Surface<F>& target, const linear::Rect& destination,
                                       const PixelView<G, Byte>& source, const Rule& rule,
                                       const linear::Rect& clip, ShowPart show_part) noexcept {
  if (!linear::in_domain(clip)) return {Error::out_of_domain, Argument::rectangle};
  if (const Status status = check_rule<F>(rule, source); !status.ok()) return status;
  const linear::Rect part = linear::intersect(linear::intersect(destination, target.bounds()), clip);
  if (part.empty() || source.empty()) return {};
  const Picture<G> picture = source;
  if (bytes_meet(target, part, picture)) return {Error::mismatched, Argument::source};
  if (meets_mask(rule, target, part)) return {Error::mismatched, Argument::mask};
  // Views and rule by value: writing a pixel can't change them then.
  show_part(part, [surface = target, picture, shown = rule](int x, int y, int column, int row) {
    show_pixel(surface, x, y, picture, column, row, shown);
  });
  return {};
}

}  // namespace detail

}  // namespace intaglio::image
