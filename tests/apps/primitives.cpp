// SPDX-License-Identifier: MIT
#include <tests/apps/program.hpp>

#include <array>
#include <firmware/apps/primitives/primitives.hpp>

namespace {

using namespace programs;
using apps::primitives::Primitives;

constexpr std::array<std::uint32_t, 4> frames{0, 31, 77, 119};

TEST(Primitives, BandsEqualTheWholeFrame) {
  expect_bands_equal_frame<Primitives, image::Indexed8>(palette_screen({320, 240}, 256), frames);
  expect_bands_equal_frame<Primitives, image::Indexed4>(grey_screen<image::Indexed4>({128, 64}), frames);
}

TEST(Primitives, EveryFrameIsSoundOnEveryScreen) {
  for (const linear::Size size : sizes) {
    expect_sound<Primitives, image::Indexed8>(palette_screen(size, 256), 0, 120, 23);
    expect_sound<Primitives, image::Indexed4>(grey_screen<image::Indexed4>(size), 0, 120, 23);
  }
  expect_sound<Primitives, image::Indexed4>(grey_screen<image::Indexed4>({128, 64}), 0, 120, 1);
  expect_sound<Primitives, image::Indexed8>(palette_screen({1920, 1080}, 256), 0, 120, 59);
}

TEST(Primitives, AFrameIsTheSameWhateverWasShownBefore) {
  expect_function_of_frame<Primitives, image::Indexed4>(palette_screen({160, 100}, 16), frames);
}

}  // namespace
