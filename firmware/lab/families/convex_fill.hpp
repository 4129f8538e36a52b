// SPDX-License-Identifier: MIT
//
// The family of convex polygon fills: by edge functions, which only they can do, and as any polygon.
#pragma once

#include <intaglio/linear/point.hpp>
#include <intaglio/raster/polygon_rungs.hpp>

#include <array>
#include <cstdint>
#include <firmware/lab/families/polygon_fill.hpp>
#include <firmware/lab/family.hpp>
#include <span>
#include <string_view>

namespace lab {

struct ConvexFill {
  static constexpr std::string_view name = "convex-fill";
  static constexpr std::string_view title = "Filling a convex polygon";
  using Rungs = intaglio::raster::ConvexFamily;
  using Default = intaglio::raster::ScanlineFill;
  static constexpr Load loads[] = {{"octagons up to 20 pixels", 8}, {"octagons of 40 to 100 pixels", 3}};

  /// An octagon around a middle: corners cut off a rectangle.
  class Input {
   public:
    constexpr Input() noexcept = default;
    constexpr Input(int load, std::uint32_t seed) noexcept {
      Random random(seed);
      const int least = load == 0 ? 2 * 128 : 40 * 128;
      const int most = load == 0 ? 20 * 128 : 100 * 128;
      const int across = random.between(least, most);
      const int down = random.between(least, most);
      const int x = random.between(60 * 256, 260 * 256);
      const int y = random.between(60 * 256, 180 * 256);
      const int cut_x = random.between(1, across - 1);
      const int cut_y = random.between(1, down - 1);
      vertices_ = {{{x - cut_x, y - down},
                    {x + cut_x, y - down},
                    {x + across, y - cut_y},
                    {x + across, y + cut_y},
                    {x + cut_x, y + down},
                    {x - cut_x, y + down},
                    {x - across, y + cut_y},
                    {x - across, y - cut_y}}};
    }
    [[nodiscard]] constexpr std::span<const intaglio::linear::SubPoint> vertices() const noexcept {
      return vertices_;
    }

   private:
    std::array<intaglio::linear::SubPoint, 8> vertices_{};
  };

  static Input input(int load, int i) noexcept { return {load, static_cast<std::uint32_t>(i + 1)}; }
  template <class R>
  static std::uint32_t run(const Input& polygon) noexcept {
    return fill_on_canvas<R>(polygon.vertices());
  }
};

}  // namespace lab
