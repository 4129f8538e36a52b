// SPDX-License-Identifier: MIT
//
// Shapes with smooth edges over a dial's face.
//
// Rule: each ink of `ink::smooth` has a ramp of entries from the face to it. How much of a pixel a shape
// covers says which step it becomes; what is covered less than half a step stays. Over something other than
// the face an edge is thus slightly darker than a true mixture. The far half of a needle is made by tinting:
// pixels of the needle's ramp become the same step of the dark one's, so the edge isn't mixed twice.
//
// Memory: 4 KiB of stack by samples, 5 KiB by area. Shapes wider than 512 pixels have hard edges.
#pragma once

#include <intaglio/linear/rect.hpp>
#include <intaglio/raster/coverage.hpp>
#include <intaglio/raster/enlargement.hpp>
#include <intaglio/raster/polygon.hpp>
#include <intaglio/raster/supersample.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <firmware/apps/canvas.hpp>
#include <firmware/apps/gauges/inks.hpp>
#include <firmware/apps/gauges/knobs.hpp>
#include <span>

namespace apps::gauges {

/// The pixels that a shape of four corners can touch.
[[nodiscard]] constexpr Rect box_of(const std::array<SubPoint, 4>& corners) noexcept {
  const auto [left, right] = std::minmax({corners[0].x, corners[1].x, corners[2].x, corners[3].x});
  const auto [top, bottom] = std::minmax({corners[0].y, corners[1].y, corners[2].y, corners[3].y});
  constexpr int bits = intaglio::linear::subpixel_bits;
  return {(left >> bits) - 1, (top >> bits) - 1, ((right - left) >> bits) + 4, ((bottom - top) >> bits) + 4};
}

/// Takes coverage: the ramp's steps, and the ink itself where all is covered.
template <class F>
class EdgeSink {
 public:
  /// `first` is the first of `steps` entries of the ramp that ends in `whole`.
  EdgeSink(const intaglio::image::Surface<F>& target, const Rect& clip, int first, int steps,
           int whole) noexcept
      : target_(target), clip_(clip), first_(first), steps_(static_cast<unsigned>(steps)), whole_(whole) {}
  [[nodiscard]] const Rect& clip() const noexcept { return clip_; }
  void span(int y, int x_begin, int x_end, int coverage) const noexcept {
    const unsigned step = intaglio::raster::coverage_step(coverage, steps_ + 1);
    if (step == 0) return;
    const int ink = step > steps_ ? whole_ : first_ + static_cast<int>(step) - 1;
    intaglio::raster::Solid<F>(target_, static_cast<unsigned>(ink)).span(y, x_begin, x_end);
  }

 private:
  intaglio::image::Surface<F> target_;
  Rect clip_;
  int first_;
  unsigned steps_;
  int whole_;
};

/// The first entry of the ramp that leads to an ink; negative if it has none.
[[nodiscard]] constexpr int edge_ramp(int shape_ink, int steps) noexcept {
  const auto* const found = std::find(ink::smooth.begin(), ink::smooth.end(), shape_ink);
  return found == ink::smooth.end() ? -1 : ink::count + static_cast<int>(found - ink::smooth.begin()) * steps;
}

/// Fills a convex shape with smooth edges; false, and nothing is drawn, if its ink has no ramp or it is too
/// wide.
template <class Canvas>
bool fill_smooth(Canvas& canvas, int shape_ink, int steps, Edges edges,
                 const std::array<SubPoint, 4>& corners) {
  using namespace intaglio;
  constexpr int widest = 512;
  const int first = edge_ramp(shape_ink, steps);
  const Rect box = box_of(corners);
  if (first < 0 || box.width > widest) return false;
  const Rect clip = linear::intersect(box, canvas.bounds());
  if (clip.empty()) return true;
  const EdgeSink<typename Canvas::Format> sink(canvas.target(), clip, first, steps, shape_ink);
  if (edges == Edges::area) {
    std::array<raster::CoverageCell, raster::coverage_cells(4, widest)> cells;
    canvas.note(fill_coverage(sink, raster::FillRule::non_zero, corners, cells));
    return true;
  }
  const int scale = edges == Edges::box_2x2 ? 2 : 4;
  const raster::Enlargement enlarge(scale);
  std::array<SubPoint, 4> enlarged{};
  std::transform(corners.begin(), corners.end(), enlarged.begin(),
                 [&](SubPoint p) { return enlarge.place(p); });
  std::array<raster::SampleCell, std::size_t{4} * widest> cells;
  std::array<raster::PolygonEdge, 4> workspace;
  canvas.note(supersample(sink, {scale, scale, raster::SampleFilter::box}, cells, [&](auto& samples) {
    return fill_polygon(samples, raster::FillRule::non_zero, enlarged, workspace);
  }));
  return true;
}

/// Takes spans: pixels of the needle's ramp become the dark needle's.
template <class F>
class TintSink {
 public:
  TintSink(const intaglio::image::Surface<F>& target, int steps) noexcept : target_(target), steps_(steps) {}
  [[nodiscard]] const Rect& clip() const noexcept { return target_.bounds(); }
  void span(int y, int x_begin, int x_end) const noexcept {
    const int light = edge_ramp(ink::needle, steps_);
    const int dark = edge_ramp(ink::needle_dark, steps_);
    for (int x = x_begin; x < x_end; ++x) {
      const int step = static_cast<int>(target_.get(x, y)) - light;
      if (step >= 0 && step < steps_)
        target_.set(x, y, static_cast<unsigned>(dark + step));
      else if (step + light == ink::needle)
        target_.set(x, y, ink::needle_dark);
    }
  }

 private:
  intaglio::image::Surface<F> target_;
  int steps_;
};

/// Tints what of the needle lies in a shape.
template <class Canvas>
void tint_smooth(Canvas& canvas, const std::array<SubPoint, 4>& corners, int steps) {
  if (!canvas.sees(box_of(corners))) return;
  std::array<intaglio::raster::PolygonEdge, 4> workspace;
  canvas.note(fill_polygon(TintSink<typename Canvas::Format>(canvas.target(), steps),
                           intaglio::raster::FillRule::non_zero, corners, workspace));
}

}  // namespace apps::gauges
