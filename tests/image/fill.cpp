// SPDX-License-Identifier: MIT
#include <intaglio/image/fill.hpp>

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

namespace {

using intaglio::image::copy_bytes_but;
using intaglio::image::fill_bytes;
using intaglio::image::flip_bytes;
using intaglio::image::map_bytes;
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

TEST(CopyBytesBut, EveryAlignmentAndLengthCopiesAllOthersAndNothingElse) {
  for (int begin = 0; begin < 8; ++begin)
    for (int from = 0; from < 8; ++from)
      for (int count = 0; count < 40; ++count) {
        std::vector<std::uint8_t> source(60);
        // Keys at all places of a word, alone and in runs, next to bytes that differ from it in one bit.
        for (unsigned i = 0; i < source.size(); ++i)
          source[i] = i * i % 7 < 3 ? 0x80 : i % 3 == 0 ? 0x00 : i % 3 == 1 ? 0x81 : 0xFF;
        std::vector<std::uint8_t> copied(60, 0x5A);
        std::vector<std::uint8_t> expected = copied;
        for (int i = 0; i < count; ++i) {
          const std::uint8_t byte = source[static_cast<unsigned>(from + i)];
          if (byte != 0x80) expected[static_cast<unsigned>(begin + i)] = byte;
        }
        copy_bytes_but(copied.data() + begin, source.data() + from, count, Pattern(0x80));
        ASSERT_EQ(copied, expected) << begin << " " << from << " " << count;
      }
}

TEST(MapBytes, EveryLengthIsMappedAndNothingElseEvenWhereRunsOverlap) {
  std::vector<std::uint8_t> table(256);
  for (unsigned i = 0; i < table.size(); ++i) table[i] = static_cast<std::uint8_t>(7 * i + 3);
  for (unsigned distance = 0; distance < 20; ++distance)
    for (unsigned count = 0; count < 40; ++count) {
      std::vector<std::uint8_t> bytes(70);
      for (unsigned i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<std::uint8_t>(i * i);
      std::vector<std::uint8_t> expected = bytes;
      for (unsigned i = 0; i < count; ++i) expected[2 + i] = table[bytes[2 + distance + i]];
      map_bytes(bytes.data() + 2, bytes.data() + 2 + distance, static_cast<int>(count), table.data());
      ASSERT_EQ(bytes, expected) << distance << " " << count;
    }
}

TEST(CopyBytesBut, RunsThatOverlapAreReadFirst) {
  for (int distance = 1; distance < 12; ++distance)
    for (int begin = 0; begin < 4; ++begin) {
      std::vector<std::uint8_t> bytes(60);
      for (unsigned i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<std::uint8_t>(i % 5);
      std::vector<std::uint8_t> expected = bytes;
      for (int i = 0; i < 40; ++i) {
        const std::uint8_t byte = bytes[static_cast<unsigned>(begin + distance + i)];
        if (byte != 3) expected[static_cast<unsigned>(begin + i)] = byte;
      }
      copy_bytes_but(bytes.data() + begin, bytes.data() + begin + distance, 40, Pattern(3));
      ASSERT_EQ(bytes, expected) << distance << " " << begin;
    }
}

}  // namespace
