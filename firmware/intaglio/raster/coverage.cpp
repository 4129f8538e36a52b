// SPDX-License-Identifier: MIT
#include <intaglio/number/long_division.hpp>
#include <intaglio/raster/coverage.hpp>

#include <algorithm>
#include <bit>
#include <memory>

namespace intaglio::raster {

namespace detail {
namespace {

constexpr int half = linear::subpixel_one / 2;
// Bits of a place beyond the 1/256 pixel: 2^-32 pixel in all.
constexpr int fraction_bits = 32 - linear::subpixel_bits;
// From 1/256 row to a height in 2^-30.
constexpr int height_bits = 30 - linear::subpixel_bits;

/// The upper side of a row, in 1/256 pixel.
constexpr int side(int row) noexcept { return row * linear::subpixel_one - half; }

/// The row or column whose sides hold a place.
constexpr int pixel_at(int place) noexcept { return (place + half) >> linear::subpixel_bits; }

constexpr std::int64_t with_fraction(int value) noexcept {
  return value * (std::int64_t{1} << fraction_bits);
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

// Taken from the row of an edge that has just begun.
constexpr int begun = 1 << 24;

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
  const auto [low, high] = vertex_box(vertices_);
  const int left = std::max(area_.x, pixel_at(low.x));
  const int top = std::max(area_.y, pixel_at(low.y));
  const int right = std::min(area_.right(), pixel_at(high.x) + 1);
  const int bottom = std::min(area_.bottom(), pixel_at(high.y) + 1);
  area_ = left < right && top < bottom ? linear::Rect{left, top, right - left, bottom - top} : linear::Rect{};
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
  const auto add = [&](int row, std::uint32_t from, std::uint32_t to) -> CoverageEdge& {
    auto* const place = reinterpret_cast<CoverageEdge*>(&cells[next]);
    next += cells_of_edge;
    return *std::construct_at(place, row, static_cast<std::int32_t>(from), static_cast<std::int32_t>(to));
  };
  CoverageEdge& last = add(INT32_MAX, 0, 0);
  last.left = INT32_MAX;
  active_ = waiting_ = end_ = &last;
  visit_edges([&](std::uint32_t from, std::uint32_t to) {
    add(std::max(Downwards(vertices_[from], vertices_[to]).first_row(), area_.y), from, to);
  });
  if (edge_count_ > 0) waiting_ = sorted(end_ + 1, end_ + 1 + edge_count_);
  last.row = INT32_MIN;  // so it never crosses a row
  cells_ = &cells[next];
  for (int i = 0; i <= area_.width; ++i) cells_[i].change_ = 0;
  return {};
}

/// Merges two lists that are sorted by row.
CoverageEdge* CoverageScan::merged(CoverageEdge* a, CoverageEdge* b) noexcept {
  CoverageEdge* head = a;
  CoverageEdge** tail = &head;
  while (a != b) {  // they meet at their end
    CoverageEdge*& lesser = b->row < a->row ? b : a;
    *tail = lesser;
    tail = &lesser->follower;
    lesser = *tail;
  }
  *tail = a;
  return head;
}

/// The edges begin .. end-1 as a list, sorted by row. The depth of the recursion is log2 of their number.
CoverageEdge* CoverageScan::sorted(CoverageEdge* begin, CoverageEdge* end) noexcept {
  if (end - begin == 1) {
    begin->follower = end_;
    return begin;
  }
  CoverageEdge* const middle = begin + (end - begin) / 2;
  CoverageEdge* const first = sorted(begin, middle);
  return merged(first, sorted(middle, end));
}

/// Puts an edge in its place in the list of those on the row.
void CoverageScan::insert(CoverageEdge& edge) noexcept {
  CoverageEdge** link = &active_;
  while ((*link)->left < edge.left) link = &(*link)->follower;
  edge.follower = *link;
  *link = &edge;
}

/// Adds the piece of an edge that lies on the row, from left to right and so high, to the cells.
[[gnu::always_inline]] inline void CoverageScan::add_piece(const CoverageEdge& edge,
                                                           const CoverageEdge::Piece& piece,
                                                           std::uint32_t height) noexcept {
  const int width = area_.width;
  const auto turn = edge.turn;
  CoverageCell* const cells = cells_;
  int before = 0;
  const auto add = [&](int column, std::uint32_t area) {
    cells[column].change_ += turn * (static_cast<int>(area) - before);
    before = static_cast<int>(area);
  };
  edge.visit_columns<false>(piece, height, width, add);
  if (piece.right() < width) add(std::max(piece.right() + 1, 0), height);
}

/// Adds the edges that begin on this row to those on it.
void CoverageScan::start_edges() noexcept {
  do {
    CoverageEdge& edge = *waiting_;
    waiting_ = edge.follower;
    start(edge);
    insert(edge);
  } while (waiting_->row == y_);
}

/// Adds the pieces of the edge at the cursor, which has advanced, and of those after it that share columns
/// with it or with each other, to the cells, and goes on to the next row with them. `first` and `last` end
/// the piece of the first.
CoverageScan::Group CoverageScan::add_group(Cursor cursor, std::int64_t first, std::int64_t last) noexcept {
  CoverageEdge::Piece piece(first, last);
  const int y = y_;
  int begin = area_.width;
  int right = -1;  // all left of the window are one group
  for (;;) {
    CoverageEdge& edge = **cursor.link;
    if (edge.row < y - begun / 2) {
      // Its piece is there already.
      begin = std::min(begin, edge.left);
      right = std::max(right, edge.right);
      edge.row += begun;
      edge.left = edge.leftmost();
    } else {
      std::uint32_t height = whole;
      if (edge.row == y) {
        piece = {edge.x, with_fraction(edge.x_end)};
        height = (edge.depth + 1U) << height_bits;
      }
      add_piece(edge, piece, height);
      begin = std::min(begin, piece.left());
      right = std::max(right, piece.right());
    }
    if (edge.row == y)
      *cursor.link = edge.follower;
    else
      place(edge, cursor);
    CoverageEdge& follower = **cursor.link;
    if (follower.left > right) break;
    piece = follower.advance(y);
  }
  return {cursor, std::max(begin, 0), std::clamp(right + 1, 0, area_.width)};
}

/// Turns an edge that waited into one on the row, and adds what it does there.
void CoverageScan::start(CoverageEdge& edge) noexcept {
  const Downwards way(vertices_[static_cast<std::uint32_t>(edge.error)],
                      vertices_[static_cast<std::uint32_t>(edge.x_end)]);
  const int left = side(area_.x);
  const int dx = way.bottom.x - way.top.x;
  const auto height = static_cast<std::uint32_t>(way.bottom.y - way.top.y);
  const int last_row = way.last_row();
  edge.turn = static_cast<std::int8_t>(way.upwards ? -1 : 1);
  edge.height = height;
  edge.row = last_row - begun;
  edge.x_end = way.bottom.x - left;
  edge.depth = static_cast<std::uint8_t>(way.bottom.y - side(last_row) - 1);
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
    const int shift = digits + up - down - 31;
    edge.up = static_cast<std::uint8_t>(std::max(-shift, 0));
    edge.down = static_cast<std::uint8_t>(std::max(shift, 0) + 1);
  }
  const auto crossing = [&](int y) { return scaled(static_cast<std::uint32_t>(y - way.top.y), dx, height); };
  const std::int64_t origin = with_fraction(way.top.x - left);
  const int row_end = side(y_ + 1);
  const int begin = std::max(way.top.y, side(y_));
  const std::int64_t x = begin == way.top.y ? origin : origin + crossing(begin).value;
  std::int64_t next = with_fraction(edge.x_end);
  if (last_row > y_) {
    const Place there = crossing(row_end);
    next = origin + there.value;
    edge.error = static_cast<std::int32_t>(there.remainder) - static_cast<std::int32_t>(height);
    // Only if it goes on from there a row is crossed from side to side, and the edge as high as that.
    const Place step =
        last_row > y_ + 1 ? scaled(linear::subpixel_one, dx, height) : Place{with_fraction(dx), 0};
    edge.step = step.value;
    edge.rest = step.remainder;
  }
  edge.x = next;
  const CoverageEdge::Piece piece(x, next);
  add_piece(edge, piece, static_cast<std::uint32_t>(std::min(way.bottom.y, row_end) - begin) << height_bits);
  edge.left = piece.left();
  edge.right = piece.right();
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
