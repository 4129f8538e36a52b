// SPDX-License-Identifier: MIT
//
// Where the visible parts of several layers go, front first.
//
// Rule: a layer's level in a pixel is round(255 * what it and all in front of it cover) less the same for
// those in front. So the levels of a pixel add up to the rounded whole: where layers cover a pixel together,
// to 255 exactly, however many there are. Each is off by less than a level for it (half a level for the
// first).
//
// To show a pixel's colour, sum levels times colours; or draw from the back with the share of what is seen
// through those in front, level / (255 - the levels in front).
#pragma once

#include <intaglio/linear/rect.hpp>
#include <intaglio/raster/coverage.hpp>

#include <concepts>
#include <utility>

namespace intaglio::raster {

/// Takes the pixels (x_begin .. x_end-1, y) of a layer, all visible to the same level, 1 to 255; of each
/// pixel the layers in their order. `clip()` is as that of a `SpanSink`.
template <class S>
concept LayerSink = requires(S& s, int layer, int y, int x_begin, int x_end, int coverage) {
  s.span(layer, y, x_begin, x_end, coverage);
  { s.clip() } -> std::convertible_to<linear::Rect>;
};

/// Hands all layers to one coverage sink (a value, or a reference); for drawings of one layer.
template <CoverageSink S>
class OneLayer {
 public:
  explicit OneLayer(S sink) : sink_(std::forward<S>(sink)) {}
  [[nodiscard]] linear::Rect clip() const { return sink_.clip(); }
  void span(int /*layer*/, int y, int x_begin, int x_end, int coverage) {
    sink_.span(y, x_begin, x_end, coverage);
  }

 private:
  S sink_;
};

}  // namespace intaglio::raster
