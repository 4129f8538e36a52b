// SPDX-License-Identifier: MIT
#include <intaglio/number/mul_div.hpp>
#include <intaglio/raster/visible_area.hpp>

#include <algorithm>
#include <utility>

namespace intaglio::raster::detail {
namespace {

constexpr int half = linear::subpixel_one / 2;
constexpr int fraction_bits = 16;
constexpr std::int64_t pixel = std::int64_t{linear::subpixel_one} << fraction_bits;
constexpr int area_bits = 2 * (linear::subpixel_bits + fraction_bits) + 1;
constexpr std::size_t polygon_limit = 1U << 16U;
constexpr std::size_t vertex_limit = coverage_vertex_limit;

constexpr std::int64_t with_fraction(int place) noexcept {
  return place * (std::int64_t{1} << fraction_bits);
}
/// The left side of a column, or the upper of a row.
constexpr int side(int column) noexcept { return column * linear::subpixel_one - half; }
/// The column of a place.
constexpr int column_of(std::int64_t place) noexcept {
  return static_cast<int>((place + with_fraction(half)) >> (linear::subpixel_bits + fraction_bits));
}

/// The x of an edge at a height between its ends.
std::int64_t x_at(const linear::SubPoint& top, const linear::SubPoint& bottom, std::int64_t y) noexcept {
  return with_fraction(top.x) +
         number::mul_div_floor(bottom.x - top.x, y - with_fraction(top.y), bottom.y - top.y);
}

/// Where between begin and end a difference of places becomes zero that goes from `from` to `to`, of opposite
/// signs; at least one step from the begin.
std::int64_t zero_of(std::int64_t begin, std::int64_t end, std::int64_t from, std::int64_t to) noexcept {
  const std::int64_t sum = from < 0 ? to - from : from - to;
  return begin +
         std::max<std::int64_t>(number::mul_div_nearest(end - begin, from < 0 ? -from : from, sum), 1);
}

constexpr bool opposite(std::int64_t a, std::int64_t b) noexcept {
  return (a < 0 && b > 0) || (a > 0 && b < 0);
}

}  // namespace

Status VisibleScan::prepare() noexcept {
  if (polygons_.size() > polygon_limit) return {Error::too_large, Argument::count, polygon_limit};
  std::size_t vertices = 0;
  for (const DepthPolygon& polygon : polygons_) {
    if (winding_mask(polygon.rule) == 0) return {Error::out_of_range, Argument::rule};
    const Status status = check_contours(polygon.vertices, polygon.contour_lengths);
    if (!status.ok()) return status;
    vertices += polygon.vertices.size();
    if (vertices > vertex_limit) return {Error::too_large, Argument::vertices, vertex_limit};
  }
  const std::size_t needed = vertices + polygons_.size();
  if (entries_.size() < needed)
    return {Error::too_small, Argument::workspace, static_cast<std::uint32_t>(needed)};
  layers_ = entries_.first(polygons_.size());
  if (clip_.empty()) clip_ = {};
  y_ = clip_.y - 1;
  x_ = clip_.right();
  return {};
}

/// Collects the edges of row y_.
void VisibleScan::start_row() noexcept {
  x_ = clip_.x;
  edges_ = entries_.subspan(layers_.size(), 0);
  int layer = 0;
  for (const DepthPolygon& polygon : polygons_) {
    const linear::SubPoint* contour = polygon.vertices.data();
    for (const int length : polygon.contour_lengths) {
      const linear::SubPoint* const end = contour + length;
      if (length >= 3)
        for (const linear::SubPoint *to = contour, *from = end - 1; to != end; from = to++)
          add_edge(layer, *from, *to);
      contour = end;
    }
    ++layer;
  }
}

void VisibleScan::add_edge(int layer, const linear::SubPoint& from, const linear::SubPoint& to) noexcept {
  const bool upwards = to.y < from.y;
  const linear::SubPoint& top = upwards ? to : from;
  const linear::SubPoint& bottom = upwards ? from : to;
  const int begin = std::max(top.y, side(y_));
  const int end = std::min(bottom.y, side(y_ + 1));
  if (begin >= end) return;
  const int first = column_of(x_at(top, bottom, with_fraction(begin)));
  const int last = column_of(x_at(top, bottom, with_fraction(end)));
  if (std::min(first, last) >= clip_.right()) return;
  edges_ = entries_.subspan(layers_.size(), edges_.size() + 1);
  VisibleEntry& edge = edges_.back();
  edge.top_ = top;
  edge.bottom_ = bottom;
  edge.layer_ = layer;
  edge.turn_ = upwards ? -1 : 1;
  edge.first_column_ = std::min(first, last);
  edge.last_column_ = std::max(first, last);
}

bool VisibleScan::next(CoverageSpan& span) noexcept {
  while (x_ >= clip_.right()) {
    if (++y_ >= clip_.bottom()) return false;
    start_row();
  }
  // Pixels that no edge touches look all alike.
  bool touched = false;
  int end = clip_.right();
  for (const VisibleEntry& edge : edges_) {
    touched |= edge.first_column_ <= x_ && x_ <= edge.last_column_;
    if (edge.first_column_ > x_) end = std::min(end, edge.first_column_);
  }
  if (touched) end = x_ + 1;
  measure(x_);
  span = {y_, x_, end, 0};
  x_ = end;
  return true;
}

int VisibleScan::level_up_to(int layer) const noexcept {
  std::int64_t sum = 0;
  for (const VisibleEntry& each : layers_.first(static_cast<std::size_t>(layer) + 1))
    sum += each.sum_or_area_;
  constexpr std::int64_t rounding = std::int64_t{1} << (area_bits - 1);
  return static_cast<int>((sum * full_coverage + rounding) >> area_bits);
}

/// Finds the visible areas in one pixel.
void VisibleScan::measure(int column) noexcept {
  for (VisibleEntry& layer : layers_) layer.sum_or_area_ = 0;
  const std::int64_t left = with_fraction(side(column));
  const std::int64_t bottom = with_fraction(side(y_ + 1));
  for (std::int64_t y = with_fraction(side(y_)); y < bottom;) {
    const std::int64_t end = slab_end(y, left);
    add_slab(y, end, left);
    y = end;
  }
}

/// Where the slab ends that begins here; makes the edges in it the active ones.
std::int64_t VisibleScan::slab_end(std::int64_t begin, std::int64_t left) noexcept {
  std::int64_t end = with_fraction(side(y_ + 1));
  std::size_t active = 0;
  for (VisibleEntry& edge : edges_) {
    const std::int64_t top = with_fraction(edge.top_.y);
    const std::int64_t bottom = with_fraction(edge.bottom_.y);
    if (top > begin) end = std::min(end, top);
    if (bottom > begin) end = std::min(end, bottom);
    if (top <= begin && bottom > begin) std::swap(edge, edges_[active++]);
  }
  active_ = edges_.first(active);
  const std::int64_t right = left + pixel;
  for (VisibleEntry& edge : active_) {
    edge.x_ = x_at(edge.top_, edge.bottom_, begin);
    edge.sum_or_area_ = x_at(edge.top_, edge.bottom_, end);
  }
  std::int64_t least = end;
  const auto cut = [&](std::int64_t from, std::int64_t to) {
    if (opposite(from, to)) least = std::min(least, zero_of(begin, end, from, to));
  };
  for (const VisibleEntry& edge : active_) {
    cut(edge.x_ - left, edge.sum_or_area_ - left);
    cut(edge.x_ - right, edge.sum_or_area_ - right);
    if (std::max(edge.x_, edge.sum_or_area_) <= left || std::min(edge.x_, edge.sum_or_area_) >= right)
      continue;
    for (const VisibleEntry& other : active_) {
      if (&other == &edge) break;
      cut(edge.x_ - other.x_, edge.sum_or_area_ - other.sum_or_area_);
    }
  }
  return least;
}

/// Adds the areas of one slab, in which edges don't cross.
void VisibleScan::add_slab(std::int64_t begin, std::int64_t end, std::int64_t left) noexcept {
  const std::int64_t right = left + pixel;
  const auto inside = [&](std::int64_t x) { return std::clamp(x, left, right); };
  // The slab ends where an edge comes in from beside the pixel. That height is rounded, and an edge of a
  // large slope may then be well inside: in this slab it isn't.
  const auto at_end = [&](const VisibleEntry& edge) {
    return edge.x_ < left || edge.x_ > right ? edge.x_ : x_at(edge.top_, edge.bottom_, end);
  };
  for (VisibleEntry& edge : active_) edge.sum_or_area_ = inside(edge.x_) + inside(at_end(edge));
  for (std::size_t i = 1; i < active_.size(); ++i)
    for (std::size_t j = i; j > 0 && active_[j].sum_or_area_ < active_[j - 1].sum_or_area_; --j)
      std::swap(active_[j], active_[j - 1]);
  for (VisibleEntry& layer : layers_) layer.turn_ = 0;
  std::int64_t x = 2 * left;
  const auto take_up_to = [&](std::int64_t next) {
    if (next == x) return;
    const int visible = front();
    if (visible >= 0) layers_[static_cast<std::size_t>(visible)].sum_or_area_ += (next - x) * (end - begin);
    x = next;
  };
  for (const VisibleEntry& edge : active_) {
    take_up_to(edge.sum_or_area_);
    layers_[static_cast<std::size_t>(edge.layer_)].turn_ += edge.turn_;
  }
  take_up_to(2 * right);
}

/// The first polygon that the place at hand is inside of; -1 if there is none.
int VisibleScan::front() const noexcept {
  for (std::size_t i = 0; i < layers_.size(); ++i)
    if ((layers_[i].turn_ & winding_mask(polygons_[i].rule)) != 0) return static_cast<int>(i);
  return -1;
}

}  // namespace intaglio::raster::detail
