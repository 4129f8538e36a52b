// SPDX-License-Identifier: MIT
#include <intaglio/image/fill.hpp>

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

namespace {

using intaglio::image::fill_bytes;
using intaglio::image::flip_bytes;
using intaglio::image::Pattern;

TEST(Fill, EveryAlignmentAndLengthWritesTheRunAndNothingElse) {
  for (int begin = 0; begin < 8; ++begin)
    for (int count = 0; count < 140; ++count) {
      std::vector<std::uint8_t> filled(160, 0x5A), expected = filled, flipped = filled, xored = filled;
      for (int i = begin; i < begin + count; ++i) {
        expected[static_cast<unsigned>(i)] = 0xC3;
        xored[static_cast<unsigned>(i)] = 0x5A ^ 0xC3;
      }
      fill_bytes(filled.data() + begin, count, Pattern(0xC3));
      flip_bytes(flipped.data() + begin, count, Pattern(0xC3));
      ASSERT_EQ(filled, expected) << begin << " " << count;
      ASSERT_EQ(flipped, xored) << begin << " " << count;
    }
}

}  // namespace
