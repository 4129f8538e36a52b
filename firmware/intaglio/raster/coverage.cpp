// SPDX-License-Identifier: MIT
#include <intaglio/number/long_division.hpp>
#include <intaglio/raster/coverage.hpp>

#include <algorithm>

namespace intaglio::raster {

namespace detail {
namespace {

constexpr int half = linear::subpixel_one / 2;
// Bits of a crossing beyond the 1/256 pixel, and of a place inside a pixel.
constexpr int fraction_bits = 16;
constexpr int place_bits = fraction_bits + linear::subpixel_bits;
// Areas count in 2^-40 pixel; a product of two places and the 2 of a mean has 9 bits more.
constexpr int area_bits = 40;
constexpr int product_shift = 2 * place_bits + 1 - area_bits;
constexpr std::int64_t whole = std::int64_t{1} << area_bits;
static_assert(product_shift == 9 && area_bits - place_bits == fraction_bits);

/// The left side of a column, or the upper of a row, in 1/256 pixel.
constexpr int side(int pixel) noexcept { return pixel * linear::subpixel_one - half; }

constexpr std::int64_t with_fraction(int value) noexcept {
  return value * (std::int64_t{1} << fraction_bits);
}

/// a * b / c, rounded down, with fraction bits. Precondition: 0 <= a <= c <= 2^29, 0 <= b <= 2^29, c > 0.
std::int64_t scaled(int a, int b, int c) noexcept {
  const auto divisor = static_cast<std::uint32_t>(c);
  const auto [quotient, remainder] =
      number::long_divide(static_cast<std::uint64_t>(a) * static_cast<std::uint64_t>(b), divisor);
  const auto fraction = number::long_divide(std::uint64_t{remainder} << fraction_bits, divisor).quotient;
  return (std::int64_t{quotient} << fraction_bits) + fraction;
}

}  // namespace

CoverageScan::CoverageScan(FillRule rule, const linear::Rect& clip,
                           const std::span<const linear::SubPoint>& vertices,
                           const std::span<const int>& contour_lengths) noexcept
    : vertices_(vertices), contour_lengths_(contour_lengths), area_(clip), rule_(rule) {}

Status CoverageScan::prepare() noexcept {
  if (winding_mask(rule_) == 0) return {Error::out_of_range, Argument::rule};
  if (vertices_.size() > static_cast<std::size_t>(coverage_vertex_limit))
    return {Error::too_large, Argument::vertices, static_cast<std::uint32_t>(coverage_vertex_limit)};
  const Status status = check_contours(vertices_, contour_lengths_);
  if (!status.ok()) return status;

  // The pixels between the outermost vertices, both included.
  linear::SubPoint low{linear::coordinate_limit * linear::subpixel_one,
                       linear::coordinate_limit * linear::subpixel_one};
  linear::SubPoint high{-low.x, -low.y};
  for (const linear::SubPoint& vertex : vertices_) {
    low = {std::min(low.x, vertex.x), std::min(low.y, vertex.y)};
    high = {std::max(high.x, vertex.x), std::max(high.y, vertex.y)};
  }
  const auto pixel = [](int place) { return (place + half) >> linear::subpixel_bits; };
  const int left = std::max(area_.x, pixel(low.x));
  const int top = std::max(area_.y, pixel(low.y));
  const int right = std::min(area_.right(), pixel(high.x) + 1);
  const int bottom = std::min(area_.bottom(), pixel(high.y) + 1);
  area_ = left < right && top < bottom ? linear::Rect{left, top, right - left, bottom - top} : linear::Rect{};
  x_ = area_.right();
  y_ = area_.y - 1;
  return {};
}

Status CoverageScan::use(const std::span<CoverageCell>& cells) noexcept {
  if (cells.size() < count()) return {Error::too_small, Argument::workspace, count()};
  cells_ = cells.data();
  for (CoverageCell& cell : cells.first(count())) cell.change_ = 0;
  return {};
}

bool CoverageScan::next(CoverageSpan& span) noexcept {
  for (;;) {
    if (x_ == area_.right()) {
      if (++y_ >= area_.bottom()) return false;
      add_row();
      x_ = area_.x;
      sum_ = 0;
    }
    span.y = y_;
    span.x_begin = x_;
    CoverageCell* cell = cells_ + (x_ - area_.x);
    sum_ += cell->change_;
    span.coverage = level(sum_);
    // Cells are left at zero for the next row.
    for (cell->change_ = 0; ++x_ < area_.right(); cell->change_ = 0) {
      ++cell;
      if (cell->change_ == 0) continue;
      if (level(sum_ + cell->change_) != span.coverage) break;
      sum_ += cell->change_;
    }
    span.x_end = x_;
    if (span.coverage != 0) return true;
  }
}

/// The level of an area that the contours wind around.
int CoverageScan::level(std::int64_t area) const noexcept {
  std::int64_t folded = area < 0 ? -area : area;
  if (rule_ == FillRule::even_odd) {
    folded &= 2 * whole - 1;
    if (folded > whole) folded = 2 * whole - folded;
  } else {
    folded = std::min(folded, whole);
  }
  return static_cast<int>((folded * full_coverage + whole / 2) >> area_bits);
}

void CoverageScan::add_row() noexcept {
  const linear::SubPoint* contour = vertices_.data();
  for (const int length : contour_lengths_) {
    const linear::SubPoint* const end = contour + length;
    if (length >= 3)
      for (const linear::SubPoint *to = contour, *from = end - 1; to != end; from = to++)
        add_edge(*from, *to);
    contour = end;
  }
}

/// Adds to the area of a column and of all to its right; what is right of the area doesn't matter.
void CoverageScan::add(int column, std::int64_t change) noexcept {
  if (column < area_.right()) cells_[column - area_.x].change_ += change;
}

/// Adds what the edge does on row y_.
void CoverageScan::add_edge(const linear::SubPoint& from, const linear::SubPoint& to) noexcept {
  // An edge runs downwards here, so both polygons that share it see the same crossings.
  const bool upwards = to.y < from.y;
  const linear::SubPoint& top = upwards ? to : from;
  const linear::SubPoint& bottom = upwards ? from : to;
  const int row_top = side(y_);
  const int begin = std::max(top.y, row_top);
  const int end = std::min(bottom.y, row_top + linear::subpixel_one);
  if (begin >= end) return;
  const bool to_right = bottom.x >= top.x;
  const linear::SubPoint& left = to_right ? top : bottom;
  const linear::SubPoint& right = to_right ? bottom : top;
  if (left.x >= side(area_.right())) return;
  const int width = right.x - left.x;
  const int height = bottom.y - top.y;
  const std::int64_t sign = upwards ? -1 : 1;
  const auto x_at = [&](int y) {
    const std::int64_t run = scaled(y - top.y, width, height);
    return with_fraction(top.x) + (to_right ? run : -run);
  };

  // The piece on this row, from its left end to its right end; y counts from the row's upper side.
  const bool hidden = right.x <= side(area_.x);
  std::int64_t x = hidden ? 0 : x_at(to_right ? begin : end);
  const std::int64_t x_end = hidden ? 0 : x_at(to_right ? end : begin);
  std::int64_t y = with_fraction((to_right ? begin : end) - row_top);
  const std::int64_t y_end = with_fraction((to_right ? end : begin) - row_top);
  const std::int64_t first_side = with_fraction(side(area_.x));
  if (hidden || x_end <= first_side) {
    add(area_.x, sign * (end - begin) * (std::int64_t{1} << (area_bits - linear::subpixel_bits)));
    return;
  }
  // What is left of the area counts as one column.
  int column =
      x < first_side ? area_.x - 1 : static_cast<int>(((x >> fraction_bits) + half) >> linear::subpixel_bits);
  for (; column < area_.right(); ++column) {
    const int next_side = side(column + 1);
    const bool last = with_fraction(next_side) >= x_end;
    const std::int64_t piece_end = last ? x_end : with_fraction(next_side);
    std::int64_t next_y = y_end;
    if (!last) {
      const std::int64_t run = scaled(next_side - left.x, height, width);
      const std::int64_t crossing = with_fraction(left.y - row_top) + (to_right ? run : -run);
      // Where a rounded x went past a side that the edge doesn't reach on this row, y stays on the row.
      next_y = to_right ? std::clamp(crossing, y, y_end) : std::clamp(crossing, y_end, y);
    }
    const std::int64_t rise = to_right ? next_y - y : y - next_y;
    const std::int64_t all = rise * (std::int64_t{1} << (area_bits - place_bits));
    if (column < area_.x) {
      add(area_.x, sign * all);
    } else {
      const std::int64_t origin = 2 * with_fraction(side(column));
      const std::int64_t own =
          (rise * ((std::int64_t{1} << (place_bits + 1)) + origin - x - piece_end)) >> product_shift;
      add(column, sign * own);
      add(column + 1, sign * (all - own));
    }
    if (last) return;
    x = piece_end;
    y = next_y;
  }
}

}  // namespace detail

Result<std::uint32_t> coverage_workspace(const std::span<const linear::SubPoint>& vertices,
                                         const std::span<const int>& contour_lengths,
                                         const linear::Rect& clip) noexcept {
  if (!linear::in_domain(clip)) return Status{Error::out_of_domain, Argument::rectangle};
  detail::CoverageScan scan(FillRule::non_zero, clip, vertices, contour_lengths);
  const Status status = scan.prepare();
  if (!status.ok()) return status;
  return scan.count();
}

}  // namespace intaglio::raster
