// SPDX-License-Identifier: MIT
//
// A test card, for bringing up a board: what is wrong with a panel shows at a glance.
//
// - One-pixel border: a picture that is shifted, cropped or has the wrong stride loses a side or slants.
// - Bars of every index from left to right: swapped nibbles or bits, and a wrong palette depth.
// - Fields of one-pixel columns and rows: swapped bit order within a byte turns the columns into pairs.
// - The frame number in binary, most significant bit left: dropped and repeated frames.
// - A box that runs along the bottom: tearing shows as a step in its sides.
#pragma once

#include <intaglio/image/palette.hpp>
#include <intaglio/image/surface.hpp>
#include <intaglio/linear/rect.hpp>
#include <intaglio/present/screen_info.hpp>
#include <intaglio/status.hpp>

#include <cstdint>
#include <span>

namespace apps::testcard {

template <intaglio::image::PixelFormat F>
class TestCard {
 public:
  explicit TestCard(const intaglio::present::ScreenInfo& screen)
      : size_(screen.size), entries_(screen.palette_entries) {}

  /// The state of that frame.
  void update(std::uint32_t frame) {
    frame_ = frame;
    // Colours that turn by an entry a frame; the first is black and the last white throughout.
    for (unsigned i = 1; i < bright; ++i) {
      const unsigned step = (i + frame) * 255U / bright;
      colours_
          .set(static_cast<int>(i), {static_cast<std::uint8_t>(step), static_cast<std::uint8_t>(step * 3U),
                                     static_cast<std::uint8_t>(255U - step)})
          .ignore();
    }
    colours_.set(static_cast<int>(bright), {255, 255, 255}).ignore();
  }
  std::span<const std::uint8_t> palette() const {
    return entries_ == 0 ? std::span<const std::uint8_t>{} : colours_.bytes();
  }

  intaglio::Status draw(intaglio::image::Surface<F> target) const {
    const intaglio::linear::Rect& b = target.bounds();
    for (int y = b.y; y < b.bottom(); ++y)
      for (int x = b.x; x < b.right(); ++x) target.set(x, y, index_at(x, y));
    return {};
  }

 private:
  static constexpr unsigned bright = F::max_index;

  [[nodiscard]] unsigned index_at(int x, int y) const {
    const int width = size_.width;
    const int height = size_.height;
    if (x == 0 || y == 0 || x == width - 1 || y == height - 1) return bright;
    const int third = height / 3;
    if (y < third) return static_cast<unsigned>(x) * (bright + 1U) / static_cast<unsigned>(width);
    if (y < 2 * third) {
      const int bit = 15 - x * 16 / width;
      if (y < third + third / 2) return (frame_ >> static_cast<unsigned>(bit) & 1U) != 0 ? bright : 0;
      return (x < width / 2 ? x : y) % 2 != 0 ? bright : 0;
    }
    const int box = static_cast<int>(frame_ * 2U % static_cast<unsigned>(width));
    return x >= box && x < box + third / 2 && y < height - third / 4 ? bright : 0;
  }

  intaglio::linear::Size size_;
  int entries_;
  std::uint32_t frame_ = 0;
  intaglio::image::Palette<static_cast<int>(F::max_index) + 1> colours_;
};

}  // namespace apps::testcard
