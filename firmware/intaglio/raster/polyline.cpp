// SPDX-License-Identifier: MIT
#include <intaglio/number/mul_div.hpp>
#include <intaglio/number/product.hpp>
#include <intaglio/raster/polyline.hpp>

#include <algorithm>
#include <array>
#include <cstdint>

namespace intaglio::raster {

namespace detail {

template class WindingScan<StrokeEdge>;

using linear::SubPoint;

/// A segment of a stroke.
struct StrokeScan::Segment {
  SubPoint from;  // where its sides begin and end: an end with a square cap is moved
  SubPoint to;
  SubPoint way;    // from vertex to vertex
  SubPoint along;  // half the width, along the way

  Segment(SubPoint a, SubPoint b, int width) noexcept
      : from(a), to(b), way{b.x - a.x, b.y - a.y}, along(half_width(a, b, width)) {}
};

namespace {

constexpr SubPoint operator+(SubPoint a, SubPoint b) noexcept { return {a.x + b.x, a.y + b.y}; }
constexpr SubPoint operator-(SubPoint a, SubPoint b) noexcept { return {a.x - b.x, a.y - b.y}; }

/// Above 0 if b turns to the right of a, on the screen.
std::int64_t cross(SubPoint a, SubPoint b) noexcept {
  return std::int64_t{a.x} * b.y - std::int64_t{a.y} * b.x;
}

constexpr std::int64_t far = 5LL << 29U;

/// a * b / c, c not 0, to the nearest, cut where it is `far`.
std::int64_t ratio(int a, std::int64_t b, std::int64_t c) noexcept {
  return std::clamp(number::mul_div_nearest(a, b, c), -far, far);
}

constexpr int shortest_miter = linear::subpixel_one;
constexpr int longest_miter = 16 * linear::subpixel_one;

/// True if a tip (x, y) away from its vertex is farther than the limit, that is
/// 2*sqrt(x^2 + y^2) > limit/256 * width. Both sides are squared; x^2 and y^2 are below 2^63.
bool beyond_limit(std::int64_t x, std::int64_t y, const Stroke& stroke) noexcept {
  const std::uint64_t reach =
      static_cast<std::uint64_t>(stroke.miter_limit) * static_cast<std::uint32_t>(stroke.width);
  const auto square = static_cast<std::uint64_t>(x * x) + static_cast<std::uint64_t>(y * y);
  constexpr std::uint64_t twice = 2 * linear::subpixel_one;
  return !number::product_at_least(reach, reach, square, twice * twice);
}
static_assert(std::uint64_t{longest_miter} * stroke_width_limit / (2 * linear::subpixel_one) <
                  far - stroke_width_limit / 2,
              "a ratio that was cut is beyond any limit");
static_assert((far + stroke_width_limit / 2) <= INT64_MAX / (far + stroke_width_limit / 2));

Status check(const std::span<const SubPoint>& points, const Stroke& stroke) noexcept {
  for (const SubPoint& point : points)
    if (!linear::in_domain(point)) return {Error::out_of_domain, Argument::vertices};
  if (stroke.width < 0 || stroke.width > stroke_width_limit) return {Error::out_of_domain, Argument::width};
  if (stroke.join > Join::round || stroke.cap > Cap::round) return {Error::out_of_range, Argument::rule};
  if (stroke.miter_limit < shortest_miter || stroke.miter_limit > longest_miter)
    return {Error::out_of_range, Argument::limit};
  return {};
}

}  // namespace

/// False if a corner is outside the domain.
bool StrokeScan::add_segment(const Segment& segment) noexcept {
  const std::array<SubPoint, 4> corners = sides(segment.from, segment.to, segment.along);
  for (const SubPoint corner : corners)
    if (!linear::in_domain(corner)) return false;
  add_contour(corners.data(), corners.data() + corners.size());
  return true;
}

/// All pieces wind like the parallelogram that `sides` gives: right of the way first.
void StrokeScan::add_triangle(SubPoint a, SubPoint b, SubPoint c) noexcept {
  if (cross(b - a, c - a) > 0) std::swap(b, c);
  const std::array<SubPoint, 3> corners{a, b, c};
  add_contour(corners.data(), corners.data() + corners.size());
}

void StrokeScan::add_disc(SubPoint centre, int diameter) noexcept {
  const int row = std::max(DiscEdge::top(centre, diameter), clip().y);
  const int end = std::min(DiscEdge::bottom(centre, diameter), clip().bottom());
  // Columns past the disc's are as far from its centre as rows are.
  const int left = DiscEdge::top({0, centre.x}, diameter);
  const int right = DiscEdge::bottom({0, centre.x}, diameter);
  if (row >= end || left >= clip().right() || right <= clip().x) return;
  for (const bool right_side : {false, true})
    if (StrokeEdge* const edge = add_entry(row, end, right_side))
      edge->start(centre, diameter, right_side, row);
}

/// False if the tip of a miter is outside the domain. The ends of the sides are in it.
bool StrokeScan::add_join(const Segment& from, const Segment& to, const Stroke& stroke) noexcept {
  const SubPoint vertex = from.to;
  const std::int64_t turn = cross(from.way, to.way);
  if (turn == 0) {
    const bool back = std::int64_t{from.way.x} * to.way.x + std::int64_t{from.way.y} * to.way.y < 0;
    if (back && stroke.join == Join::round) add_disc(vertex, stroke.width);
    return true;
  }
  if (stroke.join == Join::round) {
    add_disc(vertex, stroke.width);
    return true;
  }
  // The outer side is the left one if the way turns to the right.
  const auto outer = [&](SubPoint along) {
    return turn > 0 ? SubPoint{along.y, -along.x} : SubPoint{-along.y, along.x};
  };
  const SubPoint first = outer(from.along);
  const SubPoint second = outer(to.along);
  if (stroke.join == Join::miter) {
    // first + from.way * s = second + to.way * t; the tip is beyond both ends if s >= 0 and t <= 0.
    const std::int64_t s = cross(second - first, to.way);
    const std::int64_t t = cross(second - first, from.way);
    if (turn > 0 ? s >= 0 && t <= 0 : s <= 0 && t >= 0) {
      const std::int64_t x = first.x + ratio(from.way.x, s, turn);
      const std::int64_t y = first.y + ratio(from.way.y, s, turn);
      if (!beyond_limit(x, y, stroke)) {
        constexpr std::int64_t farthest = 2LL * stroke_width_limit;
        if (std::max({x, y, -x, -y}) > farthest) return false;
        const SubPoint tip = vertex + SubPoint{static_cast<int>(x), static_cast<int>(y)};
        if (!linear::in_domain(tip)) return false;
        add_triangle(vertex, vertex + first, tip);
        add_triangle(vertex, tip, vertex + second);
        return true;
      }
    }
  }
  add_triangle(vertex, vertex + first, vertex + second);
  return true;
}

/// The caps of a stroke that is a single point.
bool StrokeScan::add_point(SubPoint point, const Stroke& stroke) noexcept {
  if (stroke.cap == Cap::round) add_disc(point, stroke.width);
  if (stroke.cap != Cap::square) return true;
  Segment square(point, point, stroke.width);
  square.from = point - square.along;
  square.to = point + square.along;
  return add_segment(square);
}

/// False if a piece is not in the domain.
bool StrokeScan::add_segments(const std::span<const SubPoint>& points, const Stroke& stroke) noexcept {
  const SubPoint* at = points.data();
  const SubPoint* const end = at + points.size();
  /// The next point that isn't the same.
  const auto after = [&](const SubPoint* point) {
    while (point != end && *point == *at) ++point;
    return point;
  };
  const SubPoint* next = after(at);
  if (next == end) return add_point(*at, stroke);
  Segment segment(*at, *next, stroke.width);
  const Segment first = segment;
  if (!stroke.closed) {
    if (stroke.cap == Cap::square) segment.from = segment.from - segment.along;
    if (stroke.cap == Cap::round) add_disc(*at, stroke.width);
  }
  const auto go_on = [&](SubPoint to) {
    const Segment following(segment.to, to, stroke.width);
    const bool fits = add_segment(segment) && add_join(segment, following, stroke);
    segment = following;
    return fits;
  };
  for (at = next; (next = after(at)) != end; at = next)
    if (!go_on(*next)) return false;
  if (stroke.closed) {
    if (*at != points.front() && !go_on(points.front())) return false;
    return add_segment(segment) && add_join(segment, first, stroke);
  }
  if (stroke.cap == Cap::round) add_disc(*at, stroke.width);
  if (stroke.cap == Cap::square) segment.to = segment.to + segment.along;
  return add_segment(segment);
}

Status StrokeScan::prepare(const std::span<const SubPoint>& points, const Stroke& stroke) noexcept {
  const Status status = check(points, stroke);
  if (!status.ok() || points.empty() || stroke.width == 0) return status;
  if (!add_segments(points, stroke)) return {Error::out_of_domain, Argument::vertices};
  return sort();
}

}  // namespace detail

Result<std::uint32_t> polyline_workspace(const std::span<const linear::SubPoint>& points,
                                         const Stroke& stroke, const linear::Rect& clip) noexcept {
  if (!linear::in_domain(clip)) return Status{Error::out_of_domain, Argument::rectangle};
  detail::StrokeScan scan(clip, {});
  const Status status = scan.prepare(points, stroke);
  if (!status.ok() && status.argument() != Argument::workspace) return status;
  return scan.count();
}

}  // namespace intaglio::raster
