// SPDX-License-Identifier: MIT
//
// The land on the panel: which pieces are in sight, and where their vertices stand.
//
// Rule: the world repeats every 360 degrees; a piece is looked for, by its bounding box, in every copy of the
// world that the panel shows a part of, so work beyond the boxes is bounded by the pieces in sight.
// In the table, a ring that crosses the date line jumps from one end of the map to the other. Here it goes on
// instead: a step of more than half a world is taken the short way round. A ring that comes back a whole
// world away from where it began goes round a pole, and is closed along it; that closing is land's edge, but
// no shore.
#pragma once

#include <intaglio/linear/point.hpp>
#include <intaglio/linear/rect.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <firmware/apps/map/land.hpp>
#include <firmware/apps/map/projection.hpp>
#include <span>

namespace apps::map {

/// Pieces of land.
inline constexpr int piece_count = static_cast<int>(sizeof(land::polygons) / sizeof(land::polygons[0]));

/// Copies of the world, counted eastwards.
struct Copies {
  int first = 0;
  int last = 0;
};

/// The copies a panel shows a part of.
[[nodiscard]] Copies copies_in_sight(const Projection& projection, int panel_width) noexcept;

/// One piece of land in one copy of the world, projected. It holds 11 KiB: let it live where the program
/// does.
class Coast {
 public:
  /// Looks for a piece, 0 <= index < piece_count, through a window in pixels; false if it isn't in sight, and
  /// then nothing else changes. Vertices nearer than `shortest` (in 1/256 px, along both axes) to the last
  /// one kept are left out, but for the first of a contour. Cost: four products; in sight, two more for each
  /// vertex.
  bool find(int index, int copy, const Projection& projection, const intaglio::linear::Rect& window,
            int shortest = 0) noexcept;

  /// The vertices of the piece found, in 1/256 px.
  [[nodiscard]] std::span<const intaglio::linear::SubPoint> vertices() const noexcept {
    return {places_.data(), count_};
  }
  /// Vertices of each contour.
  [[nodiscard]] std::span<const int> contour_lengths() const noexcept { return {lengths_.data(), contours_}; }
  /// True if the edge between two neighbours of a contour is a shore, not the closing along a pole.
  [[nodiscard]] bool is_shore(std::size_t from, std::size_t to) const noexcept {
    return from < shore_end_ && to < shore_end_;
  }

 private:
  static constexpr std::size_t most_contours = 4;
  static constexpr std::size_t closing = 3;  // vertices that close a ring round a pole

  std::array<intaglio::linear::SubPoint, land::largest_polygon + closing> places_{};
  std::array<int, most_contours> lengths_{};
  std::size_t count_ = 0;
  std::size_t contours_ = 0;
  std::size_t shore_end_ = 0;
};

}  // namespace apps::map
