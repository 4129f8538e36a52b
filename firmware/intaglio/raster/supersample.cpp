// SPDX-License-Identifier: MIT
#include <intaglio/number/division.hpp>
#include <intaglio/raster/supersample.hpp>

#include <algorithm>

namespace intaglio::raster::detail {
namespace {

constexpr int limit = Enlargement::limit;

/// The weight of sample `i` of a window along one axis.
constexpr int weight(const Supersampling& grid, int i) noexcept {
  return grid.filter == SampleFilter::box ? 1 : std::min(i + 1, grid.width - i);
}

constexpr int total(const Supersampling& grid) noexcept {
  int sum = 0;
  for (int i = 0; i < grid.width; ++i) sum += weight(grid, i);
  return sum * sum;
}

static_assert(total({3, 3, SampleFilter::bartlett}) == 16 && total({3, 5, SampleFilter::bartlett}) == 81 &&
              total({3, 7, SampleFilter::bartlett}) == 256 && total({2, 8, SampleFilter::bartlett}) == 400);

}  // namespace

Status SampleRows::check(const Supersampling& grid, const linear::Rect& clip,
                         const std::span<SampleCell>& cells) noexcept {
  if (grid.scale < 2 || grid.scale > limit) return {Error::out_of_range, Argument::steps};
  if (grid.filter != SampleFilter::box && grid.filter != SampleFilter::bartlett)
    return {Error::out_of_range, Argument::rule};
  if (grid.width < grid.scale || grid.width > limit) return {Error::out_of_range, Argument::width};
  if ((grid.width - grid.scale) % 2 != 0 || (grid.filter == SampleFilter::box && grid.width != grid.scale))
    return {Error::mismatched, Argument::width};
  const auto needed = static_cast<std::uint32_t>(clip.empty() ? 0 : clip.width);
  if (cells.size() < needed) return {Error::too_small, Argument::workspace, needed};
  return {};
}

SampleRows::SampleRows(const Supersampling& grid, const linear::Rect& clip,
                       const std::span<SampleCell>& cells) noexcept
    : scale_(grid.scale),
      width_(grid.width),
      margin_((grid.width - grid.scale) / 2),
      clip_(clip.empty() ? linear::Rect{} : clip),
      cells_(cells.data()),
      most_rows_(0),
      levels_(total(grid)) {
  rows_ = {clip_.x, clip_.y, clip_.width, 0};
  int sum = 0;
  for (int i = width_ - 1; i >= 0; --i) {
    const int here = weight(grid, i);
    sum += here;
    weights_[static_cast<std::size_t>(i)] = static_cast<std::int16_t>(here);
    tails_[static_cast<std::size_t>(i)] = static_cast<std::int16_t>(sum);
  }
  if (clip_.empty()) return;
  const auto columns = static_cast<std::size_t>(clip_.width);
  most_rows_ = static_cast<int>(std::min(cells.size() / columns, static_cast<std::size_t>(clip_.height)));
  for (SampleCell& cell : cells.first(columns * static_cast<std::size_t>(most_rows_))) cell.change_ = 0;
}

bool SampleRows::next_pass() noexcept {
  const int y = rows_.bottom();
  rows_ = {clip_.x, y, clip_.width, std::min(most_rows_, clip_.bottom() - y)};
  if (rows_.empty()) return false;
  samples_ = {scale_ * rows_.x - margin_, scale_ * rows_.y - margin_, scale_ * rows_.width + 2 * margin_,
              scale_ * rows_.height + 2 * margin_};
  x_ = rows_.x;
  y_ = rows_.y;
  sum_ = 0;
  return true;
}

void SampleRows::add(int y, int x_begin, int x_end) noexcept {
  // The rows of pixels whose windows begin at most width - 1 above and not below.
  const int place = y + margin_;
  const int first = std::max(number::floor_div(place - width_, scale_) + 1, rows_.y);
  const int last = std::min(number::floor_div(place, scale_), rows_.bottom() - 1);
  for (int row = first; row <= last; ++row) {
    SampleCell* const cells = cells_ + (row - rows_.y) * rows_.width;
    const int row_weight = weights_[static_cast<std::size_t>(place - row * scale_)];
    add_from(cells, x_begin, row_weight);
    add_from(cells, x_end, -row_weight);
  }
}

/// Covers the samples of a row from x on.
void SampleRows::add_from(SampleCell* row, int x, int weight) const noexcept {
  const int place = x + margin_;
  int before = 0;
  for (int column = std::max(number::floor_div(place - width_, scale_) + 1, rows_.x); column < rows_.right();
       ++column) {
    const int inside = place - column * scale_;  // samples of the window left of x
    const int tail = tails_[static_cast<std::size_t>(std::max(inside, 0))];
    std::int16_t& change = row[column - rows_.x].change_;
    change = static_cast<std::int16_t>(change + weight * (tail - before));
    before = tail;
    if (inside <= 0) return;
  }
}

bool SampleRows::next(CoverageSpan& span) noexcept {
  for (;;) {
    if (x_ == rows_.right()) {
      x_ = rows_.x;
      sum_ = 0;
      ++y_;
    }
    if (y_ >= rows_.bottom()) return false;
    SampleCell* cell = cells_ + (y_ - rows_.y) * rows_.width + (x_ - rows_.x);
    sum_ += cell->change_;
    span = {y_, x_, x_ + 1, levels_(sum_)};
    // Cells are left at zero for the next rows.
    for (cell->change_ = 0; ++x_ < rows_.right(); cell->change_ = 0) {
      ++cell;
      if (levels_(sum_ + cell->change_) != span.coverage) break;
      sum_ += cell->change_;
    }
    span.x_end = x_;
    if (span.coverage != 0) return true;
  }
}

}  // namespace intaglio::raster::detail
