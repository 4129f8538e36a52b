// SPDX-License-Identifier: MIT
//
// Span sinks: where geometry ends and colour begins.
//
// Rule: a primitive decides *which* pixels; a sink decides what happens to them. A primitive hands over
// half-open spans that lie wholly inside the sink's clip rectangle, each pixel at most once, rows in any
// order. Sinks are template parameters: no virtual call, and a sink that no one uses isn't in the image.
//
// A sink may offer more than spans, and primitives take the cheaper way where it does:
// - a *cursor* (`CursorSink`) that walks pixel by pixel and needs no address arithmetic: for lines and
// outlines;
// - a *block* (`BlockSink`): a whole rectangle at once.
#pragma once

#include <intaglio/linear/rect.hpp>

#include <concepts>

namespace intaglio::raster {

/// Takes the pixels (x_begin .. x_end-1, y). `clip()` is where it can take them: a rectangle in the
/// coordinate domain without negative extent, which never changes while a primitive is drawn.
template <class S>
concept SpanSink = requires(S& s, int y, int x_begin, int x_end) {
  s.span(y, x_begin, x_end);
  { s.clip() } -> std::convertible_to<linear::Rect>;
};

/// Stands on one pixel of a surface. It may stand or pass outside the clip, but only `put` inside it. After
/// `turn_over()` it is where it was, and up() and down() have changed places.
template <class C>
concept PixelCursor = std::copyable<C> && requires(C c) {
  c.put();
  c.left();
  c.right();
  c.up();
  c.down();
  c.turn_over();
};

/// A sink that can be walked. `cursor(x, y)` needs (x, y) inside the clip.
template <class S>
concept CursorSink = SpanSink<S> && requires(S& s, int x, int y) {
  { s.cursor(x, y) } -> PixelCursor;
};

/// A sink that takes a rectangle inside the clip in one call.
template <class S>
concept BlockSink = SpanSink<S> && requires(S& s, const linear::Rect& r) {
  s.block(r);
};

/// True if the clip of a sink holds the pixel, wherever it lies.
[[nodiscard]] constexpr bool in_clip(const linear::Rect& clip, linear::Point p) noexcept {
  return static_cast<unsigned>(p.x) - static_cast<unsigned>(clip.x) < static_cast<unsigned>(clip.width) &&
         static_cast<unsigned>(p.y) - static_cast<unsigned>(clip.y) < static_cast<unsigned>(clip.height);
}

}  // namespace intaglio::raster
