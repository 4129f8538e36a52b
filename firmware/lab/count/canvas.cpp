// SPDX-License-Identifier: MIT
#include <intaglio/linear/point.hpp>

#include <array>
#include <cstddef>
#include <cstring>
#include <firmware/lab/count/kernel.hpp>

namespace lab {

namespace {

constexpr intaglio::linear::Size size{320, 240};
alignas(4) constinit std::array<std::uint8_t, static_cast<std::size_t>(size.width) * size.height> pixels{};

}  // namespace

image::Surface<image::Indexed8> canvas() noexcept {
  return image::Surface<image::Indexed8>::over(pixels, size).value();
}

void clear_canvas() noexcept { pixels.fill(0); }

namespace detail {

std::uint32_t digest_of(std::span<const std::uint32_t> numbers) noexcept {
  std::uint32_t sum = 2'166'136'261U;
  const auto add = [&sum](std::uint32_t word) { sum = (sum ^ word) * 16'777'619U; };
  for (const std::uint32_t number : numbers) add(number);
  for (std::size_t i = 0; i < pixels.size(); i += 4) {
    add(pixels[i] | std::uint32_t{pixels[i + 1]} << 8U | std::uint32_t{pixels[i + 2]} << 16U |
        std::uint32_t{pixels[i + 3]} << 24U);
  }
  return sum;
}

}  // namespace detail

}  // namespace lab
