// SPDX-License-Identifier: MIT
#include <intaglio/linear/rect.hpp>
#include <intaglio/number/product.hpp>
#include <intaglio/raster/oval.hpp>

#include <algorithm>

namespace intaglio::raster::detail {

namespace {

static_assert(linear::coordinate_limit <= 1 << 20,
              "a half axis has 21 bits, its square times a coordinate 63");

std::uint64_t square(unsigned n) noexcept { return std::uint64_t{n} * n; }

}  // namespace

Oval::Oval(linear::Point corner, int width, int height) noexcept
    : corner_(corner),
      a_(width - 1),
      b_(height - 1),
      reach_(a_),
      least_reach_(a_ & 1),
      most_reach_(a_),
      small_(OvalWalk<std::int64_t>::fits(a_, b_)),
      a_squared_(square(static_cast<unsigned>(a_))),
      b_squared_(square(static_cast<unsigned>(b_))) {}

bool Oval::holds(unsigned x, unsigned y) const noexcept {
  // x <= a and y <= b, so neither difference is negative.
  if (b_squared_ * x <= a_squared_ * y)
    return y < 1 || number::product_at_least(b_squared_, a_squared_ - square(x), a_squared_, square(y - 1));
  return number::product_at_least(a_squared_, b_squared_ - square(y), b_squared_, square(x - 1));
}

void Oval::look_at(const FromEnds& columns) noexcept {
  if (columns.first > columns.last) return;
  most_reach_ = a_ - 2 * columns.first;
  least_reach_ = a_ - 2 * columns.last;
  reach_ = std::clamp(reach_, least_reach_, most_reach_);
  row_ = -1;
  walks_ = false;
}

/// Finds the reach of the row this far from the middle.
void Oval::search(unsigned y) noexcept {
  const auto belongs = [&](int x) { return holds(static_cast<unsigned>(x), y); };
  // The middle of a row always belongs. Steps double until the end is between reach_ and reach_ + step.
  int step = 2;
  if (belongs(reach_)) {
    for (; reach_ + step <= most_reach_ && belongs(reach_ + step); step *= 2) reach_ += step;
  } else {
    for (; reach_ - step > least_reach_ && !belongs(reach_ - step); step *= 2) reach_ -= step;
    reach_ = std::max(reach_ - step, least_reach_);
  }
  while ((step /= 2) >= 2)
    if (reach_ + step <= most_reach_ && belongs(reach_ + step)) reach_ += step;
}

int Oval::inset(int from_top) noexcept {
  const int y = std::max(2 * from_top - b_, b_ - 2 * from_top);
  if (walks_ && y == row_ + 2) {
    walk_.outwards();
    for (; reach_ > least_reach_ && !walk_.belongs(); reach_ -= 2) walk_.narrower();
  } else if (walks_ && y == row_ - 2) {
    walk_.inwards();
    for (; reach_ < most_reach_; reach_ += 2) {
      walk_.wider();
      if (walk_.belongs()) continue;
      walk_.narrower();
      break;
    }
  } else if (!walks_ || y != row_) {
    // Rows nearer to the middle reach at least as far, those further away no further.
    const int settled = y < row_ ? most_reach_ : least_reach_;
    if (row_ < 0 || reach_ != settled) search(static_cast<unsigned>(y));
    walks_ = false;
  }
  row_ = y;
  // At a bound other than the box's own the oval's true reach may be far away, and the walk's error large.
  const bool at_bound = (reach_ == least_reach_ && reach_ > 1) || (reach_ == most_reach_ && reach_ != a_);
  if (!at_bound && small_ && !walks_) walk_ = {a_, b_, reach_, y};
  walks_ = !at_bound && small_;
  return (a_ - reach_) / 2;
}

RowSpan Oval::row(int y) noexcept {
  if (y < top() || y >= bottom()) return {y, 0, 0};
  const int left = inset(y - top());
  return {y, corner_.x + left, corner_.x + a_ + 1 - left};
}

Status check_ellipse(linear::Point centre, int x_radius, int y_radius) noexcept {
  if (!linear::in_domain(centre)) return {Error::out_of_domain, Argument::point};
  if (x_radius < 0 || y_radius < 0 || !linear::in_domain(x_radius) || !linear::in_domain(y_radius))
    return {Error::out_of_domain, Argument::radius};
  return {};
}

Status check_diameter(linear::Point top_left, int diameter) noexcept {
  if (!linear::in_domain(top_left)) return {Error::out_of_domain, Argument::point};
  if (diameter < 0 || !linear::length_in_domain(diameter)) return {Error::out_of_domain, Argument::size};
  return {};
}

}  // namespace intaglio::raster::detail
