// SPDX-License-Identifier: MIT
#include <intaglio/number/long_division.hpp>
#include <intaglio/raster/contours.hpp>
#include <intaglio/raster/convex.hpp>
#include <intaglio/raster/pitteway.hpp>

#include <algorithm>

namespace intaglio::raster::detail {
namespace {

constexpr int half = linear::subpixel_one / 2;
static_assert(full_coverage * (std::int64_t{1} << 37U) < std::int64_t{1} << 45U, "a level's numerator");

/// The first x of begin .. end-1 from which on the answer is true, else `end`.
template <class Predicate>
int first_where(int begin, int end, Predicate predicate) {
  while (begin < end) {
    const int middle = begin + (end - begin) / 2;
    if (predicate(middle))
      end = middle;
    else
      begin = middle + 1;
  }
  return begin;
}

/// What an edge with the longer difference `major` takes away from a pixel at `distance` (E).
int taken(std::int64_t distance, int major, bool owns_zero) noexcept {
  const std::int64_t reach = std::int64_t{half} * major;
  if (distance >= reach) return 0;
  if (distance <= -reach) return full_coverage;
  const std::int64_t numerator = full_coverage * (distance + reach) + reach - (owns_zero ? 0 : 1);
  const auto whole = static_cast<std::uint64_t>(numerator) >> linear::subpixel_bits;
  return full_coverage -
         static_cast<int>(number::long_divide(whole, static_cast<std::uint32_t>(major)).quotient);
}

}  // namespace

std::int64_t PittewayScan::Side::at(int x, int y) const noexcept {
  return std::int64_t{dx} * (y * linear::subpixel_one - from.y) -
         std::int64_t{dy} * (x * linear::subpixel_one - from.x);
}

int PittewayScan::Side::major() const noexcept {
  const int width = dx < 0 ? -dx : dx;
  const int height = dy < 0 ? -dy : dy;
  return std::max(width, height);
}

/// Calls the function with each side, those on one line once.
template <class Function>
void PittewayScan::each_side(Function function) const {
  Side last{};
  linear::SubPoint from = vertices_[corner_];
  for (std::size_t n = vertices_.size(), i = corner_; n > 0; --n) {
    if (++i == vertices_.size()) i = 0;
    const linear::SubPoint to = vertices_[i];
    const linear::SubPoint start = clockwise_ ? from : to;
    const linear::SubPoint end = clockwise_ ? to : from;
    from = to;
    const Side side{start, end.x - start.x, end.y - start.y};
    if (side.dx == 0 && side.dy == 0) continue;
    // A convex polygon doesn't turn back: parallel to the last side means on its line.
    const bool first = last.dx == 0 && last.dy == 0;
    if (!first && std::int64_t{side.dx} * last.dy == std::int64_t{side.dy} * last.dx) continue;
    last = side;
    function(side);
  }
}

Status PittewayScan::prepare(const std::span<const linear::SubPoint>& vertices) noexcept {
  for (const linear::SubPoint& vertex : vertices)
    if (!linear::in_domain(vertex)) return {Error::out_of_domain, Argument::vertices};
  const int turn = turning(vertices);
  if (turn == not_convex) return {Error::malformed, Argument::vertices};
  if (turn == 0) box_ = {};
  if (box_.empty()) return {};
  const auto [least, most] = vertex_box(vertices);
  const auto pixel = [](int place) { return (place + half) >> linear::subpixel_bits; };
  const int left = pixel(least.x);
  const int top = pixel(least.y);
  box_ = linear::intersect(box_, {left, top, pixel(most.x) - left + 1, pixel(most.y) - top + 1});
  vertices_ = vertices;
  clockwise_ = turn > 0;
  // The topmost of the leftmost vertices is a corner.
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const linear::SubPoint& best = vertices[corner_];
    const linear::SubPoint& here = vertices[i];
    if (here.x < best.x || (here.x == best.x && here.y < best.y)) corner_ = i;
  }
  y_ = box_.y - 1;
  return {};
}

/// Finds where the pixels between nothing and full lie on row y_.
void PittewayScan::start_row() noexcept {
  int begin = box_.x;
  int end = box_.right();
  int full_begin = begin;
  int full_end = end;
  each_side([&](const Side& side) {
    const std::int64_t reach = std::int64_t{half} * side.major();
    const auto inside = [&](int x) { return side.at(x, y_) > -reach; };
    const auto full = [&](int x) { return side.at(x, y_) >= reach; };
    const auto not_inside = [&](int x) { return !inside(x); };
    const auto not_full = [&](int x) { return !full(x); };
    if (full(box_.x) && full(box_.right() - 1)) return;
    if (side.dy < 0) {
      begin = std::max(begin, first_where(box_.x, box_.right(), inside));
      full_begin = std::max(full_begin, first_where(box_.x, box_.right(), full));
    } else {  // the whole row alike, if the side is level
      end = std::min(end, first_where(box_.x, box_.right(), not_inside));
      full_end = std::min(full_end, first_where(box_.x, box_.right(), not_full));
    }
  });
  x_ = begin;
  x_end_ = std::max(begin, end);
  full_begin_ = full_begin;
  full_end_ = full_end;
}

int PittewayScan::level(int x) const noexcept {
  const auto taken_by = [&](const Side& side) {
    return taken(side.at(x, y_), side.major(), side.dy < 0 || (side.dy == 0 && side.dx > 0));
  };
  int most = 0;
  Side first{};
  each_side([&](const Side& side) {
    const int here = taken_by(side);
    if (here <= most) return;
    most = here;
    first = side;
  });
  int opposite = 0;
  each_side([&](const Side& side) {
    if (std::int64_t{side.dx} * first.dx + std::int64_t{side.dy} * first.dy < 0)
      opposite = std::max(opposite, taken_by(side));
  });
  return std::max(full_coverage - most - opposite, 0);
}

bool PittewayScan::next(CoverageSpan& span) noexcept {
  if (box_.empty()) return false;
  for (;;) {
    while (x_ == x_end_) {
      if (++y_ >= box_.bottom()) return false;
      start_row();
    }
    span = {y_, x_, x_ + 1, full_coverage};
    if (x_ >= full_begin_ && x_ < full_end_) {
      span.x_end = x_ = full_end_;
      return true;
    }
    const int limit = x_ < full_begin_ && full_begin_ < full_end_ ? full_begin_ : x_end_;
    span.coverage = level(x_);
    while (++x_ < limit && level(x_) == span.coverage) {
    }
    span.x_end = x_;
    if (span.coverage != 0) return true;
  }
}

}  // namespace intaglio::raster::detail
