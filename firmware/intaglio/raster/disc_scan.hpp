// SPDX-License-Identifier: MIT
//
// The visible rows of a disc and of its outline.
//
// Rule: the rows at distance j above and below the centre reach `outer` = half_chord(r, j) to both sides. The
// outline has of them what the rows one further out don't hide: from `inner` = half_chord(r, j + 1) + 1, or
// from `outer` if that is less, to `outer`. So every pixel of the outline comes once, and a disc is its
// outline and its filling.
//
// Rows beyond the diagonal are the runs of an octant's walk, taken from the furthest inwards; rows up to it
// are the walk's steps, taken from the nearest outwards. half_chord finds where to start: no row or column
// outside the window is walked, at any radius. Rows that fill the window from side to side need no walk.
//
// Bit budget: distances within 2^22: int32.
// Error: none.
#pragma once

#include <intaglio/linear/point.hpp>
#include <intaglio/linear/rect.hpp>
#include <intaglio/raster/octant.hpp>
#include <intaglio/status.hpp>

namespace intaglio::raster::detail {

/// Says whether centre and radius are in the domain. Errors: point, radius.
[[nodiscard]] Status check_circle(linear::Point centre, int radius) noexcept;

/// True if all of the circle is in the clip.
[[nodiscard]] bool wholly_visible(linear::Point centre, int radius, const linear::Rect& clip) noexcept;

/// The rows `distance` above and below the centre.
struct DiscRow {
  int distance;
  int inner;  ///< Where the outline begins, counted from the centre.
  int outer;  ///< Where outline and disc end (not beyond it); r on rows that fill the window.
};

/// What of a circle is wanted.
enum class Part : bool { disc, outline };

/// Goes through the rows that have visible pixels, and perhaps a few of which only one of the pair or, of the
/// outline, nothing is visible.
class DiscScan {
 public:
  /// Precondition: centre and radius are in the domain.
  DiscScan(linear::Point centre, int radius, const linear::Rect& clip, Part part) noexcept;
  /// Puts the next rows in `row`; false if there are none.
  [[nodiscard]] bool next(DiscRow& row) noexcept;

 private:
  int radius_;
  int filled_;     // rows filled_ .. first_ - 1 fill the window
  int first_;      // nearest row to walk
  int last_ = -1;  // furthest row
  int inner_ = 0;
  bool beyond_diagonal_ = true;
  Octant walk_{0, 0, -1};
};

inline bool DiscScan::next(DiscRow& row) noexcept {
  if (beyond_diagonal_) {
    // A run of the walk is complete when v falls, or at the diagonal.
    for (int v; v = walk_.v(), v >= walk_.t() && v >= first_ && v <= last_;) {
      if (!walk_.next() && walk_.t() <= v) continue;
      row = {v, inner_, walk_.t() - 1};
      inner_ = walk_.t();
      return true;
    }
    beyond_diagonal_ = false;
    walk_ = Octant(radius_, first_);
  }
  if (walk_.t() < walk_.v() && walk_.t() <= last_) {
    row = {walk_.t(), walk_.v(), walk_.v()};
    walk_.next();
    return true;
  }
  row = {filled_, 0, radius_};
  return filled_++ < first_;
}

/// Calls draw(y, row) for every row of the scan inside the clip.
template <class Draw>
void scan_disc(linear::Point centre, int radius, const linear::Rect& clip, Part part, Draw draw) {
  DiscScan scan(centre, radius, clip, part);
  for (DiscRow row; scan.next(row);) {
    for (int y = centre.y + row.distance;; y = centre.y - row.distance) {
      if (static_cast<unsigned>(y - clip.y) < static_cast<unsigned>(clip.height)) draw(y, row);
      if (y <= centre.y) break;
    }
  }
}

}  // namespace intaglio::raster::detail
