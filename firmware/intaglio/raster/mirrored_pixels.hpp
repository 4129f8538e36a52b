// SPDX-License-Identifier: MIT
//
// A pixel and its images around a centre, each once and only where it is visible: for rungs that find an
// outline pixel by pixel.
//
// Rule: the images of (across, down), both >= 0, have either sign on either axis; on an axis two of them are
// one. Bit budget: centre within 2^20, distances within 2^20. Error: none.
#pragma once

#include <intaglio/linear/point.hpp>
#include <intaglio/linear/rect.hpp>
#include <intaglio/raster/sink.hpp>
#include <intaglio/status.hpp>

#include <cstdint>

namespace intaglio::raster::detail {

/// What is wrong with a radius: what was found before, or that it is above the most that a rung takes.
[[nodiscard]] constexpr Status at_most(Status status, int radius, int most) noexcept {
  if (!status.ok() || radius <= most) return status;
  return {Error::too_large, Argument::radius, static_cast<std::uint32_t>(most)};
}

/// Puts the pixels (+-across, +-down) around the centre.
template <SpanSink S>
void put_quadrants(S& sink, const linear::Rect& clip, linear::Point centre, int across, int down) {
  const auto put = [&](int x, int y) {
    if (in_clip(clip, {x, y})) sink.span(y, x, x + 1);
  };
  put(centre.x + across, centre.y + down);
  if (across != 0) put(centre.x - across, centre.y + down);
  if (down == 0) return;
  put(centre.x + across, centre.y - down);
  if (across != 0) put(centre.x - across, centre.y - down);
}

/// Those, and with x and y swapped.
template <SpanSink S>
void put_octants(S& sink, const linear::Rect& clip, linear::Point centre, int across, int down) {
  put_quadrants(sink, clip, centre, across, down);
  if (across != down) put_quadrants(sink, clip, centre, down, across);
}

}  // namespace intaglio::raster::detail
