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
// From 1/256 row to a height in units of areas.
constexpr std::uint32_t height_unit = CoverageEdge::whole / linear::subpixel_one;

/// The upper side of a row, in 1/256 pixel.
constexpr int side(int row) noexcept { return row * linear::subpixel_one - half; }

/// The row or column whose sides hold a place.
constexpr int pixel_at(int place) noexcept { return (place + half) >> linear::subpixel_bits; }

using Place = CoverageEdge::Place;

constexpr std::uint32_t upper(std::uint64_t fraction) noexcept {
  return static_cast<std::uint32_t>(fraction >> 32U);
}
/// n * 2^32 / d, rounded down. Precondition: n < d <= 2^29.
number::LongDivision fraction_of(std::uint32_t n, std::uint32_t d) noexcept {
  if (d > 0xFFFFU) return number::long_divide(std::uint64_t{n} << 32U, d);
  const std::uint32_t high = (n << 16U) / d;
  const std::uint32_t rest = (n << 16U) - high * d;
  const std::uint32_t low = (rest << 16U) / d;
  return {high << 16U | low, (rest << 16U) - low * d};
}
/// a / b, rounded down. Precondition: |a| <= 2^29, 0 < b <= 2^29.
Place quotient(std::int32_t a, std::uint32_t b) noexcept {
  const auto size = static_cast<std::uint32_t>(a < 0 ? -a : a);
  const std::uint32_t whole = size / b;
  const number::LongDivision high = fraction_of(size - whole * b, b);
  const number::LongDivision low = fraction_of(high.remainder, b);
  const Place place{static_cast<int>(whole), std::uint64_t{high.quotient} << 32U | low.quotient};
  if (a >= 0) return place;
  // Rounded down once negated, and that is the complement, unless there is nothing to round.
  if (low.remainder != 0 || place.fraction != 0)
    return {~place.column, ~place.fraction + (low.remainder == 0)};
  return {-place.column, 0};
}
/// origin + step * n / 256, for an origin in 1/256, and up to 2^-42 more, so that neither this nor what is
/// stepped from it is too little: places that fall on a multiple of 2^-32 stay there when they are rounded
/// down to one. Precondition: n, |step| * n <= 2^29.
Place stepped(std::int32_t origin, const Place& step, std::uint32_t n) noexcept {
  // All steps down an edge, which is up to 2^29 high, lack less than 2^29 in 2^-72.
  constexpr std::uint64_t lacking = 1U << 30U;
  const std::uint64_t low = std::uint64_t{static_cast<std::uint32_t>(step.fraction)} * n + lacking;
  const std::uint64_t middle = (step.fraction >> 32U) * n + (low >> 32U);
  const std::int64_t high = std::int64_t{step.column} * static_cast<std::int32_t>(n) +
                            static_cast<std::int64_t>(middle >> 32U) + origin;
  constexpr unsigned bits = linear::subpixel_bits;
  return {static_cast<int>(high >> bits), static_cast<std::uint64_t>(high) << (64U - bits) |
                                              (middle << 32U | static_cast<std::uint32_t>(low)) >> bits};
}

/// Where an edge runs, downwards: so both polygons that share it see the same crossings.
struct Downwards {
  linear::SubPoint top;
  linear::SubPoint bottom;
  bool upwards;  // as the contour runs

  Downwards(const linear::SubPoint& from, const linear::SubPoint& to) noexcept
      : top(to.y < from.y ? to : from), bottom(to.y < from.y ? from : to), upwards(to.y < from.y) {}
  [[nodiscard]] int last_row() const noexcept { return pixel_at(bottom.y - 1); }
};

}  // namespace

CoverageScan::CoverageScan(FillRule rule, const linear::Rect& clip,
                           const std::span<const linear::SubPoint>& vertices,
                           const std::span<const int>& contour_lengths) noexcept
    : vertices_(vertices), contour_lengths_(contour_lengths), area_(clip), rule_(rule) {
  head_.left = INT32_MIN;
}

/// Calls visit(index, index) with the ends of each edge that adds something to the area.
template <class Visit>
void CoverageScan::visit_edges(Visit visit) const noexcept {
  const int top = side(area_.y);
  const int bottom = side(area_.bottom());
  const int right = side(area_.right());
  std::uint32_t begin = 0;
  for (const int length : contour_lengths_) {
    const std::uint32_t end = begin + static_cast<std::uint32_t>(length);
    if (length >= 3) {
      for (std::uint32_t to = begin, from = end - 1; to != end; from = to++) {
        const linear::SubPoint& a = vertices_[from];
        const linear::SubPoint& b = vertices_[to];
        if (a.y != b.y && std::max(a.y, b.y) > top && std::min(a.y, b.y) < bottom &&
            std::min(a.x, b.x) < right)
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
  return {};
}

std::uint32_t CoverageScan::count() const noexcept {
  if (area_.empty()) return 0;
  std::size_t edges = 0;
  visit_edges([&](std::uint32_t, std::uint32_t) { ++edges; });
  return static_cast<std::uint32_t>(coverage_cells(edges, area_.width));
}

Status CoverageScan::use(const std::span<CoverageCell>& cells) noexcept {
  if (area_.empty()) return {};
  // Most often there is room for all edges, and no need to count those that add something.
  if (cells.size() < coverage_cells(vertices_.size(), area_.width)) {
    const std::uint32_t needed = count();
    if (cells.size() < needed) return {Error::too_small, Argument::workspace, needed};
  }
  // Edges first: all are aligned alike. Cells that change their type begin a new life.
  std::size_t next = 0;
  const auto add = [&](int row, std::uint32_t from, std::uint32_t to) -> CoverageEdge* {
    auto* const place = reinterpret_cast<CoverageEdge*>(&cells[next]);
    next += cells_of_edge;
    return std::construct_at(place, row, static_cast<std::int32_t>(from), static_cast<std::int32_t>(to));
  };
  head_.follower = waiting_ = end_ = add(INT32_MAX, 0, 0);
  end_->left = INT32_MAX;
  CoverageEdge* last = end_;
  visit_edges([&](std::uint32_t from, std::uint32_t to) {
    last = add(std::max(pixel_at(std::min(vertices_[from].y, vertices_[to].y)), area_.y), from, to);
  });
  if (last != end_) waiting_ = sorted(end_ + 1, last + 1);
  cells_ = &cells[next];
  for (int i = 0; i <= area_.width; ++i) cells_[i].change_ = 0;
  return {};
}

/// Merges two lists that are sorted by row.
CoverageEdge* CoverageScan::merged(CoverageEdge* a, CoverageEdge* b) noexcept {
  CoverageEdge* head = nullptr;
  CoverageEdge** tail = &head;
  for (;;) {
    if (b->row < a->row) {
      *tail = b;
      tail = &b->follower;
      b = *tail;
      if (b == end_) break;
    } else {
      *tail = a;
      tail = &a->follower;
      a = *tail;
      if (a == end_) break;
    }
  }
  *tail = a == end_ ? b : a;
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
  CoverageEdge* before = &head_;
  while (before->follower->left < edge.left) before = before->follower;
  edge.follower = before->follower;
  before->follower = &edge;
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
  if (piece.right < width) add(std::max(piece.right + 1, 0), height);
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

/// Up to which row, or an earlier one, an edge that has gone on to the next row touches visible columns only,
/// before its last row.
int CoverageScan::plain_until(const CoverageEdge& edge) const noexcept {
  if (!visible(edge.left) || !visible(edge.right)) return INT32_MIN;
  if (visible(edge.end_column())) return edge.row;
  const bool leftwards = edge.step_columns < 0;
  const int room = leftwards ? edge.left : area_.width - 1 - edge.right;
  const int most = leftwards ? -edge.step_columns : edge.step_columns + 1;  // columns a row
  return std::min(edge.row, y_ + 2 + room / most);
}

/// Adds the pieces of the edge after `before`, and of those after it that share columns with it or with each
/// other, to the cells, and goes on to the next row with them.
CoverageScan::Group CoverageScan::add_group(CoverageEdge* before) noexcept {
  const int y = y_;
  int begin = area_.width;
  int right = -1;  // all left of the window are one group
  CoverageEdge* follower = before->follower;
  do {
    CoverageEdge& edge = *follower;
    follower = edge.follower;
    if (edge.row == y) {
      const CoverageEdge::Piece piece = edge.last_piece();
      begin = std::min(begin, piece.left);
      right = std::max(right, piece.right);
      add_piece(edge, piece, (edge.last_height + 1U) * height_unit);
      before->follower = follower;
    } else {
      const CoverageEdge::Piece piece = edge.piece();
      begin = std::min(begin, piece.left);
      right = std::max(right, piece.right);
      add_piece(edge, piece, (edge.height + 1U) * height_unit);
      edge.height = linear::subpixel_one - 1;
      place(edge, follower, before);
      edge.plain = plain_until(edge);
    }
  } while (follower->left <= right);
  return {before, std::max(begin, 0), std::clamp(right + 1, 0, area_.width)};
}

/// Turns an edge that waited into one on the row.
void CoverageScan::start(CoverageEdge& edge) noexcept {
  const Downwards way(vertices_[static_cast<std::uint32_t>(edge.column)],
                      vertices_[static_cast<std::uint32_t>(edge.x_end)]);
  const int left = side(area_.x);
  const int dx = way.bottom.x - way.top.x;
  const int origin = way.top.x - left;
  const auto height = static_cast<std::uint32_t>(way.bottom.y - way.top.y);
  const int row_end = side(y_ + 1);
  const int begin = std::max(way.top.y, side(y_));
  Place step{0, 0};
  if (dx != 0) {
    step = quotient(dx, height);
    // The quotient of both, each with its highest bit in bit 31, to 32 bits.
    const auto width = static_cast<std::uint32_t>(dx < 0 ? -dx : dx);
    const int up = std::countl_zero(height);
    const int down = std::countl_zero(width);
    const std::uint32_t n = height << static_cast<unsigned>(up);
    const std::uint32_t d = width << static_cast<unsigned>(down);
    const int digits = n >= d ? 31 : 32;
    // Halves: both are even, and the dividend stays below 2^63.
    const std::uint32_t ratio =
        number::long_divide(std::uint64_t{n / 2} << static_cast<unsigned>(digits), d / 2).quotient;
    const int shift = digits + up - down - 30;
    const std::uint64_t slope = std::uint64_t{ratio - ratio / 256 - 1} << 32U >> std::max(shift, 0);
    edge.up = static_cast<std::uint8_t>(std::max(-shift, 0));
    edge.slope = upper(slope);
    edge.slope_fine = static_cast<std::uint32_t>(slope);
  }
  edge.turn = static_cast<std::int8_t>(way.upwards ? -1 : 1);
  edge.row = way.last_row();
  edge.x_end = way.bottom.x - left;
  edge.step_columns = step.column;
  edge.step_fraction = upper(step.fraction);
  edge.step_fine = static_cast<std::uint32_t>(step.fraction);
  const Place from = begin == way.top.y
                         ? stepped(origin, {0, 0}, 0)
                         : stepped(origin, step, static_cast<std::uint32_t>(begin - way.top.y));
  edge.top_fraction = upper(from.fraction);
  int last_column = pixel_at(edge.x_end - half);
  if (edge.row == y_) {
    edge.last_height = static_cast<std::uint8_t>(way.bottom.y - begin - 1);
  } else {
    edge.height = static_cast<std::uint8_t>(row_end - begin - 1);
    edge.last_height = static_cast<std::uint8_t>(way.bottom.y - side(edge.row) - 1);
    const Place to = stepped(origin, step, static_cast<std::uint32_t>(row_end - way.top.y));
    edge.column = last_column = to.column;
    edge.fraction = upper(to.fraction);
    edge.fine = static_cast<std::uint32_t>(to.fraction);
  }
  edge.left = std::min(from.column, last_column);
  edge.right = std::max(from.column, last_column);
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
