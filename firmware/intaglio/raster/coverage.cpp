// SPDX-License-Identifier: MIT
#include <intaglio/number/long_division.hpp>
#include <intaglio/raster/coverage.hpp>

#include <algorithm>
#include <memory>
#include <utility>

namespace intaglio::raster {

namespace detail {
namespace {

constexpr int half = linear::subpixel_one / 2;
// Bits of a place beyond the 1/256 pixel: 2^-32 pixel in all.
constexpr int fraction_bits = 32 - linear::subpixel_bits;
// From 1/256 row to a height in 2^-31.
constexpr int height_bits = 31 - linear::subpixel_bits;
constexpr std::uint32_t whole_height = 1U << 31U;

/// The upper side of a row, in 1/256 pixel.
constexpr int side(int row) noexcept { return row * linear::subpixel_one - half; }

/// The row or column whose sides hold a place.
constexpr int pixel_at(int place) noexcept { return (place + half) >> linear::subpixel_bits; }

constexpr std::int64_t with_fraction(int value) noexcept {
  return value * (std::int64_t{1} << fraction_bits);
}

/// The upper 32 bits of a product.
constexpr std::uint32_t multiply_high(std::uint32_t a, std::uint32_t b) noexcept {
  return static_cast<std::uint32_t>(std::uint64_t{a} * b >> 32U);
}

struct Place {
  std::int64_t value;       // with fraction bits, rounded down
  std::uint32_t remainder;  // over the divisor
};
/// a * b / c for a b of either sign. Precondition: a, |b| <= 2^29, 0 < c <= 2^29, |a * b| / c < 2^32.
Place scaled(std::uint32_t a, std::int32_t b, std::uint32_t c) noexcept {
  const bool negative = b < 0;
  const auto size = static_cast<std::uint32_t>(negative ? -b : b);
  const auto whole = number::long_divide(std::uint64_t{a} * size, c);
  const auto fraction = number::long_divide(std::uint64_t{whole.remainder} << fraction_bits, c);
  const std::int64_t value = (std::int64_t{whole.quotient} << fraction_bits) + fraction.quotient;
  if (!negative) return {value, fraction.remainder};
  if (fraction.remainder == 0) return {-value, 0};
  return {-value - 1, c - fraction.remainder};
}

/// Where an edge runs, downwards: so both polygons that share it see the same crossings.
struct Downwards {
  linear::SubPoint top;
  linear::SubPoint bottom;
  bool upwards;  // as the contour runs

  Downwards(const linear::SubPoint& from, const linear::SubPoint& to) noexcept
      : top(to.y < from.y ? to : from), bottom(to.y < from.y ? from : to), upwards(to.y < from.y) {}
  [[nodiscard]] int first_row() const noexcept { return pixel_at(top.y); }
  [[nodiscard]] int last_row() const noexcept { return pixel_at(bottom.y - 1); }
};

constexpr bool starts_later(const CoverageEdge& a, const CoverageEdge& b) noexcept { return a.row > b.row; }

}  // namespace

CoverageScan::CoverageScan(FillRule rule, const linear::Rect& clip,
                           const std::span<const linear::SubPoint>& vertices,
                           const std::span<const int>& contour_lengths) noexcept
    : vertices_(vertices), contour_lengths_(contour_lengths), area_(clip), rule_(rule) {}

/// Calls visit(index, index) with the ends of each edge that adds something to the area.
template <class Visit>
void CoverageScan::visit_edges(Visit visit) const noexcept {
  std::uint32_t begin = 0;
  for (const int length : contour_lengths_) {
    const std::uint32_t end = begin + static_cast<std::uint32_t>(length);
    if (length >= 3) {
      for (std::uint32_t to = begin, from = end - 1; to != end; from = to++) {
        const linear::SubPoint& a = vertices_[from];
        const linear::SubPoint& b = vertices_[to];
        const Downwards edge(a, b);
        if (a.y != b.y && edge.last_row() >= area_.y && edge.first_row() < area_.bottom() &&
            std::min(a.x, b.x) < side(area_.right()))
          visit(from, to);
      }
    }
    begin = end;
  }
}

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
  const int left = std::max(area_.x, pixel_at(low.x));
  const int top = std::max(area_.y, pixel_at(low.y));
  const int right = std::min(area_.right(), pixel_at(high.x) + 1);
  const int bottom = std::min(area_.bottom(), pixel_at(high.y) + 1);
  area_ = left < right && top < bottom ? linear::Rect{left, top, right - left, bottom - top} : linear::Rect{};
  y_ = area_.y - 1;
  cell_count_ = 0;
  edge_count_ = 0;
  if (area_.empty()) return {};
  visit_edges([&](std::uint32_t, std::uint32_t) { ++edge_count_; });
  cell_count_ =
      static_cast<std::uint32_t>(coverage_cells(static_cast<std::size_t>(edge_count_), area_.width));
  return {};
}

Status CoverageScan::use(const std::span<CoverageCell>& cells) noexcept {
  if (cells.size() < cell_count_) return {Error::too_small, Argument::workspace, cell_count_};
  if (cell_count_ == 0) return {};
  // Edges first: all are aligned alike. Cells that change their type begin a new life.
  std::size_t next = 0;
  active_ = 0;
  waiting_ = edge_count_;
  visit_edges([&](std::uint32_t from, std::uint32_t to) {
    auto* const edge = std::construct_at(reinterpret_cast<CoverageEdge*>(&cells[next]), CoverageEdge{});
    if (next == 0) edges_ = edge;
    edge->row = std::max(Downwards(vertices_[from], vertices_[to]).first_row(), area_.y);
    edge->height = from;
    edge->rest = to;
    next += cells_of_edge;
  });
  std::make_heap(edges_, edges_ + edge_count_, starts_later);
  cells_ = &cells[next];
  for (int i = 0; i <= area_.width; ++i) cells_[i].change_ = 0;
  const int words = area_.width / 32 + 1;
  auto* const storage = reinterpret_cast<std::uint32_t*>(cells_ + area_.width + 1);
  for (int i = 0; i < words; ++i) std::construct_at(storage + i, 0U);
  touched_ = storage;
  return {};
}

/// Adds to a column what an edge covers of it to its right, and to all further right the edge's height there.
inline void CoverageScan::add(int column, std::uint32_t own, std::uint32_t height, bool upwards) noexcept {
  CoverageCell* const cell = cells_ + column;
  if (upwards) {
    cell[0].change_ -= own;
    cell[1].change_ -= height - own;
  } else {
    cell[0].change_ += own;
    cell[1].change_ += height - own;
  }
  const unsigned bit = static_cast<unsigned>(column) % 32;
  std::uint32_t* const touched = touched_ + column / 32;
  touched[0] |= 3U << bit;
  if (bit == 31) touched[1] |= 1;
}

/// Adds the piece of an edge that lies on the row, between these columns and so high.
[[gnu::always_inline]] inline void CoverageScan::add_piece(const CoverageEdge& edge, std::int64_t x,
                                                           std::int64_t x_end,
                                                           std::uint32_t height) noexcept {
  const auto column = static_cast<int>(x >> 32);
  if (column == static_cast<int>(x_end >> 32) &&
      static_cast<unsigned>(column) < static_cast<unsigned>(area_.width)) {
    // Right of it lies the mean of the distances of its ends from the column's right side.
    const std::uint32_t distance =
        (~static_cast<std::uint32_t>(x) >> 1U) + (~static_cast<std::uint32_t>(x_end) >> 1U) + 1;
    add(column, multiply_high(height, distance), height, edge.upwards);
    return;
  }
  add_columns(edge, x, x_end, height);
}

bool CoverageScan::next_row() noexcept {
  if (++y_ >= area_.bottom()) return false;
  CoverageEdge* const end = edges_ + edge_count_;
  for (CoverageEdge* edge = end - active_; edge != end; ++edge) {
    const std::int64_t x = edge->x;
    const bool last = edge->row == y_;
    std::int64_t next = 0;
    std::uint32_t height = whole_height;
    if (last) {
      next = with_fraction(edge->x_end);
      height = static_cast<std::uint32_t>(edge->end) << height_bits;
    } else {
      next = x + edge->step;
      std::int32_t error = edge->error + static_cast<std::int32_t>(edge->rest);
      if (error >= 0) {
        error -= static_cast<std::int32_t>(edge->height);
        ++next;
      }
      edge->error = error;
      edge->x = next;
    }
    add_piece(*edge, x, next, height);
    if (last) *edge = end[-active_--];  // which has had its turn
  }
  while (waiting_ > 0 && edges_->row == y_) {
    std::pop_heap(edges_, edges_ + waiting_, starts_later);
    CoverageEdge edge = edges_[--waiting_];
    start(edge);
    if (edge.row > y_) end[-++active_] = edge;
  }
  return true;
}

/// Turns an edge that waited into one on the row, and adds what it does there.
void CoverageScan::start(CoverageEdge& edge) noexcept {
  const Downwards way(vertices_[edge.height], vertices_[edge.rest]);
  const int left = side(area_.x);
  const int dx = way.bottom.x - way.top.x;
  const auto height = static_cast<std::uint32_t>(way.bottom.y - way.top.y);
  edge.upwards = way.upwards;
  edge.height = height;
  edge.row = way.last_row();
  edge.x_end = way.bottom.x - left;
  edge.end = static_cast<std::int16_t>(way.bottom.y - side(edge.row));
  if (dx != 0) {
    // The quotient of both, each with its highest bit in bit 31, to 32 bits.
    const auto width = static_cast<std::uint32_t>(dx < 0 ? -dx : dx);
    const int up = std::countl_zero(height);
    const int down = std::countl_zero(width);
    const std::uint32_t n = height << static_cast<unsigned>(up);
    const std::uint32_t d = width << static_cast<unsigned>(down);
    const int digits = n >= d ? 31 : 32;
    // Halves: both are even, and the dividend stays below 2^63.
    edge.slope = number::long_divide(std::uint64_t{n / 2} << static_cast<unsigned>(digits), d / 2).quotient;
    edge.slope_shift = static_cast<std::uint8_t>(digits + up - down);
  }
  const auto crossing = [&](int y) { return scaled(static_cast<std::uint32_t>(y - way.top.y), dx, height); };
  const std::int64_t origin = with_fraction(way.top.x - left);
  const int row_end = side(y_ + 1);
  const int begin = std::max(way.top.y, side(y_));
  const std::int64_t x = begin == way.top.y ? origin : origin + crossing(begin).value;
  if (way.bottom.y <= row_end) {
    add_piece(edge, x, with_fraction(edge.x_end),
              static_cast<std::uint32_t>(way.bottom.y - begin) << height_bits);
    return;
  }
  const Place next = crossing(row_end);
  edge.x = origin + next.value;
  edge.error = static_cast<std::int32_t>(next.remainder) - static_cast<std::int32_t>(height);
  if (edge.row > y_ + 1) {  // only then is a row crossed from side to side, and the edge as high as that
    const Place step = scaled(linear::subpixel_one, dx, height);
    edge.step = step.value;
    edge.rest = step.remainder;
  }
  add_piece(edge, x, edge.x, static_cast<std::uint32_t>(row_end - begin) << height_bits);
}

/// The same for a piece that goes through several columns, or isn't all visible.
void CoverageScan::add_columns(const CoverageEdge& edge, std::int64_t left, std::int64_t right,
                               std::uint32_t height) noexcept {
  if (left > right) std::swap(left, right);
  auto column = static_cast<int>(left >> 32);
  const auto last = static_cast<int>(right >> 32);
  if (column >= area_.width) return;
  if (last < 0) {
    add(0, height, height, edge.upwards);
    return;
  }
  // How high the edge is over a part of a column, and over whole ones in 2^-63 row.
  const auto rise = [&](std::uint32_t part) {
    return static_cast<std::uint32_t>(std::uint64_t{part} * edge.slope >> (edge.slope_shift + 1U));
  };
  std::uint32_t done = 0;  // of the height
  if (column < 0) {
    const std::int64_t hidden = -left;
    const auto columns = static_cast<std::uint32_t>(hidden >> 32);
    const std::uint64_t whole =
        columns == 0 ? 0 : std::uint64_t{columns} * edge.slope >> (edge.slope_shift - 31U);
    done = std::min(static_cast<std::uint32_t>(whole) + rise(static_cast<std::uint32_t>(hidden)), height);
    add(0, done, done, edge.upwards);
    column = 0;
  } else if (column < last) {
    const std::uint32_t distance = ~static_cast<std::uint32_t>(left);
    done = std::min(rise(distance), height);
    add(column, multiply_high(done, distance) / 2, done, edge.upwards);
    ++column;
  }
  const int end = std::min(last, area_.width);
  if (column < end) {
    const std::uint64_t step = std::uint64_t{edge.slope} << (63U - edge.slope_shift);
    std::uint64_t sum = std::uint64_t{done} << 32U;
    for (; column < end; ++column) {
      sum += step;
      const std::uint32_t next = std::min(static_cast<std::uint32_t>(sum >> 32U), height);
      add(column, (next - done) / 2, next - done, edge.upwards);
      done = next;
    }
  }
  if (column == last && column < area_.width) {
    const std::uint32_t rest = height - done;
    add(column, rest - multiply_high(rest, static_cast<std::uint32_t>(right)) / 2, rest, edge.upwards);
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
