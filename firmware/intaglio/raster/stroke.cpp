// SPDX-License-Identifier: MIT
#include <intaglio/number/long_division.hpp>
#include <intaglio/number/product.hpp>
#include <intaglio/number/root.hpp>
#include <intaglio/raster/stroke.hpp>

namespace intaglio::raster::detail {
namespace {

constexpr std::uint32_t magnitude(int c) noexcept { return static_cast<std::uint32_t>(c < 0 ? -c : c); }

/// w*d/(2*L), rounded, where `length` is L rounded.
int part(std::uint32_t d, std::uint32_t w, std::uint32_t length, std::uint64_t length_squared) noexcept {
  const std::uint64_t product = std::uint64_t{d} * w;
  auto [nearest, rest] = number::long_divide(product + length, 2 * length);
  // The true quotient is within w / 2^31 of this one. So where the rest is within w of 0 or of the divisor,
  // the tie next to it decides: nearest - 1/2 or nearest + 1/2.
  const bool low = rest <= w && nearest != 0;
  const bool high = 2 * length - rest <= w;
  if (low || high) {
    const std::uint64_t tie = 2 * std::uint64_t{nearest} + 1 - (low ? 2 : 0);
    const bool reached = number::product_at_least(product, product, tie * tie, length_squared);
    if (low != reached) nearest += reached ? 1U : -1U;
  }
  return static_cast<int>(nearest);
}

}  // namespace

linear::SubPoint half_width(linear::SubPoint a, linear::SubPoint b, int width) noexcept {
  std::uint32_t dx = magnitude(b.x - a.x);
  std::uint32_t dy = magnitude(b.y - a.y);
  if (dx == 0 && dy == 0) dx = 1;
  for (; ((dx | dy) >> 29U) == 0; dx <<= 1U) dy <<= 1U;
  const std::uint64_t length_squared = std::uint64_t{dx} * dx + std::uint64_t{dy} * dy;
  const std::uint32_t length = number::isqrt_nearest(length_squared);
  const auto w = static_cast<std::uint32_t>(width);
  const int x = part(dx, w, length, length_squared);
  const int y = part(dy, w, length, length_squared);
  return {b.x < a.x ? -x : x, b.y < a.y ? -y : y};
}

}  // namespace intaglio::raster::detail
