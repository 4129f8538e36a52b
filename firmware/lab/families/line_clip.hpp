// SPDX-License-Identifier: MIT
//
// The family of clipped lines: with parameters of 16 or 32 fraction bits, and exactly, by three clippers. All
// round the ends once to 1/256 pixel.
#pragma once

#include <intaglio/clip/line_window_rungs.hpp>
#include <intaglio/linear/point.hpp>
#include <intaglio/linear/sub_rect.hpp>

#include <cstdint>
#include <firmware/lab/family.hpp>
#include <string_view>
#include <type_traits>

namespace lab {

struct LineClip {
  static constexpr std::string_view name = "line-clip";
  static constexpr std::string_view title = "Clipping a line to the screen";
  using Rungs = intaglio::clip::LineWindowFamily;
  using Default = intaglio::clip::LiangBarsky;
  static constexpr Load loads[] = {
      {"ends around the screen", 128}, {"most lines inside", 128}, {"ends up to a million pixels away", 128}};
  static constexpr intaglio::linear::SubRect window{0, 0, 319 * 256, 239 * 256};
  /// How far the ends of a load are from the middle of the screen, in pixels.
  static constexpr int reach[] = {512, 200, 1 << 20};

  struct Input {
    intaglio::linear::SubPoint from;
    intaglio::linear::SubPoint to;
  };
  static Input input(int load, int i) noexcept {
    Random random(static_cast<std::uint32_t>(i + 1));
    if (load == 1) {
      return {{random.between(-2'000, 322 * 256), random.between(-2'000, 242 * 256)},
              {random.between(-2'000, 322 * 256), random.between(-2'000, 242 * 256)}};
    }
    const int far = load == 0 ? 256 * 350 : 256 * 1'000'000;
    const intaglio::linear::SubPoint from{random.between(-far, far), random.between(-far, far)};
    // Three of four go somewhere through the screen, or end there.
    if (load == 0 || i % 4 == 0)
      return {{from.x + 160 * 256, from.y + 120 * 256}, {random.between(0, 319 * 256), -from.y}};
    return {from, {-from.x + random.between(0, 600 * 256), -from.y + random.between(0, 400 * 256)}};
  }
  template <class R>
  static std::uint32_t run(const Input& line) noexcept {
    const auto clipped = R{}(line.from, line.to, window);
    if (!clipped.ok() || !clipped.value().visible) return 0;
    const auto& ends = clipped.value();
    return static_cast<std::uint32_t>(ends.from.x * 31 + ends.from.y * 37 + ends.to.x * 41 + ends.to.y * 43) |
           1U;
  }

  /// The distance of an end from its exact place, in pixels. Exactly clipped ends lie on a side of the
  /// window, so only one coordinate is rounded: 1/512. Rounded parameters: at most sqrt(2) * (1/512 + L *
  /// 2^-(bits + 1)) with coordinates that differ by up to L.
  template <class R>
  static constexpr number::Bound bound(int load) noexcept {
    constexpr int of_16_bits[] = {14, 7, 22'631};
    constexpr int of_32_bits[] = {3, 3, 4};
    int thousandths = 2;
    if (std::is_same_v<R, intaglio::clip::Parameters16>) thousandths = of_16_bits[load];
    if (std::is_same_v<R, intaglio::clip::Parameters32>) thousandths = of_32_bits[load];
    return number::pixels(thousandths);
  }
};

}  // namespace lab
