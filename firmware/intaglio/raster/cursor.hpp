// SPDX-License-Identifier: MIT
//
// A cursor for every sink: its own where it has one, else one that sends spans of a single pixel.
#pragma once

#include <intaglio/raster/sink.hpp>

#include <type_traits>

namespace intaglio::raster {

/// Walks a sink that has no cursor of its own.
template <SpanSink S>
class SpanCursor {
 public:
  constexpr SpanCursor(S& sink, int x, int y) noexcept : sink_(&sink), x_(x), y_(y) {}
  constexpr void put() const { sink_->span(y_, x_, x_ + 1); }
  constexpr void left() noexcept { --x_; }
  constexpr void right() noexcept { ++x_; }
  constexpr void up() noexcept { y_ -= down_; }
  constexpr void down() noexcept { y_ += down_; }
  constexpr void turn_over() noexcept { down_ = -down_; }

 private:
  S* sink_;
  int x_;
  int y_;
  int down_ = 1;
};

/// A cursor on pixel (x, y). Precondition: the pixel is inside the sink's clip.
template <SpanSink S>
[[nodiscard]] constexpr auto cursor_at(S& sink, int x, int y) {
  if constexpr (CursorSink<S>)
    return sink.cursor(x, y);
  else
    return SpanCursor<S>(sink, x, y);
}

}  // namespace intaglio::raster
