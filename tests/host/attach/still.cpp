// SPDX-License-Identifier: MIT
//
// One picture on panels of all kinds.
#include <hal/sim/catalog.hpp>
#include <hal/sim/panel.hpp>
#include <host/attach/still.hpp>
#include <host/failure.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <random>
#include <string>
#include <vector>

namespace {

using testing::AllOf;
using testing::HasSubstr;

class Simulated final : public host::AttachedPanel {
 public:
  explicit Simulated(const char* name) : panel_(*hal::sim::find_panel(name), clock_) {}
  hal::Panel& panel() override { return panel_; }
  std::string description() const override { return "a simulated panel"; }
  [[nodiscard]] hal::sim::Picture displayed() { return panel_.displayed(); }

 private:
  hal::sim::VirtualClock clock_;
  hal::sim::Panel panel_;
};

host::IndexedPicture random_picture(int width, int height, int bits) {
  std::mt19937 random(60'503);
  host::IndexedPicture picture{width, height, {}, {}};
  for (int i = 0; i < width * height; ++i)
    picture.indices.push_back(static_cast<std::uint8_t>(random() & ((1U << bits) - 1U)));
  for (int i = 0; i < 3 << bits; ++i)
    picture.palette_rgb.push_back(static_cast<std::uint8_t>(random() & 0xF8U));
  return picture;
}

std::array<int, 3> colour(const std::vector<std::uint8_t>& rgb, std::size_t index) {
  return {rgb[3U * index], rgb[3U * index + 1U], rgb[3U * index + 2U]};
}

TEST(Still, APanelWithAPaletteShowsThePicturesColours) {
  for (const char* const name : {"40x30x8", "33x17x4", "19x9x2", "97x33x1", "vga"}) {
    Simulated attached(name);
    const hal::Capabilities& c = attached.panel().capabilities();
    const host::IndexedPicture picture = random_picture(c.width - 3, c.height - 2, c.bits_per_pixel);
    host::show_still(attached, picture);
    const hal::sim::Picture shown = attached.displayed();
    int wrong = 0;
    for (int y = 0; y < c.height; ++y)
      for (int x = 0; x < c.width; ++x) {
        const bool inside = x < picture.width && y < picture.height;
        const std::size_t index =
            inside ? picture.indices[static_cast<std::size_t>(y * picture.width + x)] : 0U;
        wrong += colour(shown.rgb, static_cast<std::size_t>(y * c.width + x)) !=
                 colour(picture.palette_rgb, index);
      }
    EXPECT_EQ(wrong, 0) << name;
  }
}

TEST(Still, APanelOfFixedColoursShowsTheNearest) {
  for (const char* const name : {"oled", "ssd1306"}) {
    Simulated attached(name);
    const hal::Capabilities& c = attached.panel().capabilities();
    const host::IndexedPicture picture = random_picture(c.width, c.height, 8);
    host::show_still(attached, picture);
    const hal::sim::Picture shown = attached.displayed();
    const auto distance = [](const std::array<int, 3>& a, const std::array<int, 3>& b) {
      int sum = 0;
      for (std::size_t i = 0; i < 3; ++i) sum += (a.at(i) - b.at(i)) * (a.at(i) - b.at(i));
      return sum;
    };
    const std::vector<std::uint8_t> fixed(c.fixed_palette.begin(), c.fixed_palette.end());
    int wrong = 0;
    for (std::size_t i = 0; i < picture.indices.size(); ++i) {
      const auto wanted = colour(picture.palette_rgb, picture.indices[i]);
      const int got = distance(wanted, colour(shown.rgb, i));
      for (std::size_t k = 0; k < fixed.size() / 3U; ++k) wrong += distance(wanted, colour(fixed, k)) < got;
    }
    EXPECT_EQ(wrong, 0) << name;
  }
}

std::string refusal(const char* panel, const host::IndexedPicture& picture) {
  try {
    Simulated attached(panel);
    host::show_still(attached, picture);
  } catch (const host::Failure& failure) {
    return failure.what();
  }
  return "it was accepted";
}

TEST(Still, WhatDoesNotFitIsSaid) {
  EXPECT_THAT(refusal("40x30x8", random_picture(41, 30, 8)),
              AllOf(HasSubstr("41x30"), HasSubstr("a simulated panel")));
  EXPECT_THAT(refusal("40x30x8", random_picture(40, 31, 8)), HasSubstr("40x31"));
  EXPECT_THAT(refusal("40x30x4", random_picture(8, 8, 8)), HasSubstr("256 colours is too much for the 16"));
}

}  // namespace
