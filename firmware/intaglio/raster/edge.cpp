// SPDX-License-Identifier: MIT
#include <intaglio/number/division.hpp>
#include <intaglio/raster/edge.hpp>

#include <cstdint>

namespace intaglio::raster {

static_assert((std::int64_t{1} << 29U) * (std::int64_t{1} << 30U) + (std::int64_t{1} << 37U) < INT64_MAX,
              "the numerator of a crossing fits int64");
static_assert(linear::coordinate_limit * 2LL * linear::subpixel_one <= 1LL << 29U,
              "differences have 30 bits");

namespace {

/// floor(a / b) and remainder for b > 0 where the quotient fits int; in 32 bits where `a` does, which on a
/// core without a 64-bit divider is four times cheaper.
number::Division<int> divide(std::int64_t a, int b) noexcept {
  if (b <= 0) __builtin_unreachable();  // spares the checks of a divisor that never comes
  const int narrow = static_cast<int>(a);
  if (narrow == a) return number::floor_divide(narrow, b);
  const auto wide = number::floor_divide(a, b);
  return {static_cast<int>(wide.quotient), static_cast<int>(wide.remainder)};
}

}  // namespace

void Edge::start(const linear::SubPoint& top, const linear::SubPoint& bottom, int row) noexcept {
  height_ = bottom.y - top.y;
  // Everything is negated, because ceil(M/dy) = -floor(-M/dy) and likewise for the division by 256.
  const int dx = top.x - bottom.x;
  const auto [step, remainder] = divide(dx, height_);
  step_ = -step;
  remainder_ = remainder;
  const std::int64_t numerator = std::int64_t{dx} * (row * linear::subpixel_one - top.y) -
                                 std::int64_t{top.x & (linear::subpixel_one - 1)} * height_;
  const auto [columns, error] = divide(numerator >> linear::subpixel_bits, height_);
  x_ = (top.x >> linear::subpixel_bits) - columns;
  error_ = error - height_;
}

}  // namespace intaglio::raster
