// SPDX-License-Identifier: MIT
#include <intaglio/number/long_division.hpp>
#include <intaglio/number/root.hpp>
#include <intaglio/raster/thick_line_rungs.hpp>

#include <algorithm>
#include <cstdint>

namespace intaglio::raster {

namespace detail {

LineRuns::LineRuns(const clip::LinePath& path) noexcept
    : begin_(path.start.x),
      end_(path.start.x),
      left_(path.count),
      error_(path.error),
      minor_step_(path.minor_step),
      major_step_(path.major_step) {
  if (left_ > 0) extend();
}

/// Takes in the pixel at the run's end and all after it on the same row.
void LineRuns::extend() noexcept {
  do {
    ++end_;
    --left_;
    error_ += minor_step_;
  } while (error_ < 0 && left_ > 0);
  error_ -= major_step_;
}

void LineRuns::go_to(int row) noexcept {
  while (row_ < row && left_ > 0) {
    ++row_;
    begin_ = end_;
    extend();
  }
}

Status MinorThickScan::prepare(linear::SubPoint a, linear::SubPoint b, int thickness,
                               const linear::Rect& clip) noexcept {
  if (!linear::in_domain(a) || !linear::in_domain(b)) return {Error::out_of_domain, Argument::point};
  if (thickness < 0 || !linear::in_domain(thickness)) return {Error::out_of_domain, Argument::width};
  if (thickness == 0 || clip.empty()) return {};
  const int before = thickness / 2;
  const int after = thickness - 1 - before;
  // Where the line is if its runs reach into the clip.
  linear::Rect window = clip;
  const bool steep = std::max(b.y - a.y, a.y - b.y) > std::max(b.x - a.x, a.x - b.x);
  if (steep) {
    window.x -= after;
    window.width += before + after;
  } else {
    window.y -= after;
    window.height += before + after;
  }
  const Status status = clip::line_path(a, b, window, path_);
  if (!status.ok() || path_.count == 0) return status;
  thickness_ = thickness;
  if (steep) {
    before_ = before;
    end_ = path_.count;
    return {};
  }
  first_ = last_ = LineRuns(path_);
  before_ = path_.up ? after : before;
  const int start = path_.start.y;
  row_ = std::max(-before_, path_.up ? start - clip.bottom() + 1 : clip.y - start);
  end_ = path_.up ? start - clip.y + 1 : clip.bottom() - start;
  return {};
}

bool MinorThickScan::next(RowSpan& span) noexcept {
  if (row_ >= end_) return false;
  const int y = path_.start.y + (path_.up ? -row_ : row_);
  if (path_.steep) {
    const int begin = path_.start.x - before_;
    span = {y, begin, begin + thickness_};
    path_.error += path_.minor_step;
    if (path_.error >= 0) {
      path_.error -= path_.major_step;
      ++path_.start.x;
    }
  } else {
    // The first column whose run reaches down to this row, and the last whose run reaches up to it.
    const int reach = row_ - (thickness_ - 1 - before_);
    first_.go_to(reach);
    if (first_.row() < reach) return false;
    last_.go_to(row_ + before_);
    span = {y, first_.begin(), last_.end()};
  }
  ++row_;
  return true;
}

}  // namespace detail

int MinorWidth::operator()(linear::Point a, linear::Point b, int width) const noexcept {
  const auto magnitude = [](int d) { return static_cast<std::uint32_t>(d < 0 ? -d : d); };
  const std::uint32_t dx = magnitude(b.x - a.x);
  const std::uint32_t dy = magnitude(b.y - a.y);
  const std::uint32_t major = std::max(dx, dy);
  const std::uint32_t asked = static_cast<std::uint32_t>(width) * linear::subpixel_one;
  if (major == 0) return static_cast<int>(asked);
  // The length in 1/256 pixel: 21 + 1/2 + 8 bits.
  const std::uint32_t length =
      number::isqrt_nearest((std::uint64_t{dx} * dx + std::uint64_t{dy} * dy) << (2 * linear::subpixel_bits));
  const std::uint64_t product = std::uint64_t{asked} * major * linear::subpixel_one;
  return static_cast<int>(number::long_divide(product + length / 2, length).quotient);
}

}  // namespace intaglio::raster
