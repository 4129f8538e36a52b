// SPDX-License-Identifier: MIT
#include "badge.hpp"

#include <hal/mock/strict_panel.hpp>

#include <gtest/gtest.h>

TEST(Badge, ShowsThree) {
  hal::mock::StrictPanel panel(hal::mock::write_panel(7, 7, 8));
  ASSERT_TRUE(draw_badge(panel.recorder(1)).ok());
  panel.expect_writes({
      "..###..",
      ".#.#.#.",
      "#..#..#",
      "#..####",
      "#.....#",
      ".#...#.",
      "..###..",
  });
}
