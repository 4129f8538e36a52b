// SPDX-License-Identifier: MIT
#include <intaglio/number/long_division.hpp>
#include <intaglio/raster/edge.hpp>

#include <cstdint>

namespace intaglio::raster {

static_assert((std::int64_t{1} << 29U) * (std::int64_t{1} << 30U) + (std::int64_t{1} << 37U) < INT64_MAX,
              "the numerator of a crossing fits int64");
static_assert(linear::coordinate_limit * 2LL * linear::subpixel_one <= 1LL << 29U,
              "differences have 30 bits");

namespace {

struct Quotient {
  int floor;
  int remainder;
};

/// floor(a / b) and a - floor * b for b > 0 where the quotient fits int.
Quotient divide(std::int64_t a, int b) noexcept {
  // For a < 0 divide ~a = -a - 1 instead: floor(a / b) = ~floor(~a / b).
  const std::int64_t sign = a >> 63U;
  const auto [quotient, remainder] =
      number::long_divide(static_cast<std::uint64_t>(a ^ sign), static_cast<unsigned>(b));
  const int flip = static_cast<int>(sign);
  return {static_cast<int>(quotient) ^ flip, (static_cast<int>(remainder) ^ flip) + (b & flip)};
}

}  // namespace

void Edge::start(const linear::SubPoint& top, const linear::SubPoint& bottom, int row) noexcept {
  height_ = bottom.y - top.y;
  // Everything is negated, because ceil(M/dy) = -floor(-M/dy) and likewise for the division by 256.
  const int dx = top.x - bottom.x;
  const auto [step, remainder] = divide(dx, height_);
  step_ = -step;
  remainder_ = remainder;
  x_ = top.x >> linear::subpixel_bits;
  error_ = -height_;
  const int below = row * linear::subpixel_one - top.y;
  const int right = top.x & (linear::subpixel_one - 1);
  // An edge from a pixel's centre stands there.
  if ((below | right) == 0) return;
  const std::int64_t numerator = std::int64_t{dx} * below - std::int64_t{right} * height_;
  const auto [columns, error] = divide(numerator >> linear::subpixel_bits, height_);
  x_ -= columns;
  error_ += error;
}

}  // namespace intaglio::raster
