// SPDX-License-Identifier: MIT
//
// Ways to clip a polygon to a convex window: side by side with new vertices rounded, or exactly.
//
// Rule: the places inside both contours, by even-odd. `SutherlandHodgman` (convex.hpp) leaves one contour
// whose new vertices are rounded to 1/256 pixel; `GreinerHormann` (greiner_hormann.hpp) and `CutAndClassify`
// (boolean.hpp), which know no convex windows but any, leave exact ones. All write contours to the memory
// they are given, in the rung's `Vertex`, which `nearest` rounds, and work in its `Cell`s.
//
// Error: how far a vertex lies from the outline it was cut from, in pixels: at most 0.71/256 for each side of
// the window, of which there are up to 64. Bit budget, cost and worst known inputs: in those headers.
// Textbook: sections 2.9.3 and 2.9.4.
#pragma once

#include <intaglio/clip/boolean.hpp>
#include <intaglio/clip/convex.hpp>
#include <intaglio/clip/greiner_hormann.hpp>
#include <intaglio/linear/point.hpp>
#include <intaglio/number/bound.hpp>
#include <intaglio/status.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace intaglio::clip {

/// A vertex that is rounded already.
[[nodiscard]] constexpr linear::SubPoint nearest(linear::SubPoint vertex) noexcept { return vertex; }

/// Side by side. Errors: as `clip_to_convex`; buffer also if there is no room for one length; too_large count
/// for more sides than 64.
struct SutherlandHodgman {
  static constexpr std::string_view domain = "windows of up to 64 sides";
  using Vertex = linear::SubPoint;
  using Cell = ClipStage;
  /// The most sides that a window has.
  static constexpr int most_sides = 64;
  static constexpr number::Bound bound = number::pixels((710 * most_sides + 255) / 256);

  [[nodiscard]] Result<BooleanResult> operator()(const std::span<const linear::SubPoint>& polygon,
                                                 const std::span<const linear::SubPoint>& window,
                                                 const std::span<Vertex>& vertices,
                                                 const std::span<int>& contour_lengths,
                                                 const std::span<Cell>& workspace) const noexcept {
    if (window.size() > std::size_t{most_sides}) return Status{Error::too_large, Argument::count, most_sides};
    if (contour_lengths.empty()) return Status{Error::too_small, Argument::buffer, 1};
    const auto left = clip_to_convex(polygon, window, vertices, workspace);
    if (!left.ok()) return left.status();
    const std::size_t count = left.value().size();
    contour_lengths[0] = static_cast<int>(count);
    return BooleanResult{count, count == 0 ? std::size_t{0} : std::size_t{1}};
  }
};

namespace detail {

/// The combining functions, called alike.
template <class Node, auto combine_by>
struct ExactPolygonClip {
  static constexpr number::Bound bound = number::exactly(number::Unit::pixel);
  using Vertex = BooleanVertex;
  using Cell = Node;

  /// Errors: as the combining function's.
  [[nodiscard]] Result<BooleanResult> operator()(const std::span<const linear::SubPoint>& polygon,
                                                 const std::span<const linear::SubPoint>& window,
                                                 const std::span<Vertex>& vertices,
                                                 const std::span<int>& contour_lengths,
                                                 const std::span<Cell>& workspace) const noexcept {
    const int of_polygon = static_cast<int>(polygon.size());
    const int of_window = static_cast<int>(window.size());
    return combine_by(BooleanRule::intersection, {polygon, std::span<const int>(&of_polygon, 1)},
                      {window, std::span<const int>(&of_window, 1)}, vertices, contour_lengths, workspace);
  }
};

}  // namespace detail

/// Crossings found once, then walked; refuses operands that touch.
struct GreinerHormann : detail::ExactPolygonClip<RingNode, combine_greiner_hormann> {
  static constexpr std::string_view domain = "contours that don't touch the window's, within 2,048 pixels";
};
/// All edges cut at all contacts, the pieces told apart; takes whatever touches.
struct CutAndClassify : detail::ExactPolygonClip<BooleanPiece, combine> {
  static constexpr std::string_view domain = "places within 2,048 pixels";
};

/// The rungs of clipping polygons, cheapest first.
using PolygonClipFamily = number::Family<SutherlandHodgman, GreinerHormann, CutAndClassify>;

}  // namespace intaglio::clip
