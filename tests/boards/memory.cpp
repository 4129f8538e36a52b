// SPDX-License-Identifier: MIT
//
// The boards' memory functions, compiled for the host under other names.
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <vector>

// The source is included, not linked: under their own names the functions would stand in for the C library's
// in the whole program, and what checks them would run on them.
#define memset board_memset
#define memcpy board_memcpy
#define memmove board_memmove
#define memcmp board_memcmp
#include <firmware/boards/common/memory.cpp>  // NOLINT(bugprone-suspicious-include)
#undef memset
#undef memcpy
#undef memmove
#undef memcmp

namespace {

using Bytes = std::vector<unsigned char>;
constexpr std::size_t room = 64;  // A multiple of the word, so that whole words at the ends exist.

Bytes numbered(unsigned seed) {
  Bytes bytes(room);
  for (std::size_t i = 0; i < room; ++i) bytes[i] = static_cast<unsigned char>(i * 37U + seed);
  return bytes;
}

TEST(BoardMemory, CopiesEveryLengthBetweenAllAlignments) {
  for (std::size_t to = 0; to < 8; ++to)
    for (std::size_t from = 0; from < 8; ++from)
      for (std::size_t count = 0; count <= room - 8; ++count) {
        const Bytes source = numbered(1);
        Bytes target = numbered(2);
        Bytes expected = target;
        for (std::size_t i = 0; i < count; ++i) expected[to + i] = source[from + i];
        ASSERT_EQ(board_memcpy(&target[to], &source[from], count), &target[to]);
        ASSERT_EQ(target, expected) << to << ' ' << from << ' ' << count;
      }
}

TEST(BoardMemory, MovesEveryLengthOverItselfBetweenAllPlaces) {
  for (std::size_t to = 0; to < 24; ++to)
    for (std::size_t from = 0; from < 24; ++from)
      for (std::size_t count = 0; count <= room - 24; ++count) {
        Bytes memory = numbered(3);
        const Bytes source = memory;
        Bytes expected = memory;
        for (std::size_t i = 0; i < count; ++i) expected[to + i] = source[from + i];
        ASSERT_EQ(board_memmove(&memory[to], &memory[from], count), &memory[to]);
        ASSERT_EQ(memory, expected) << to << ' ' << from << ' ' << count;
      }
}

TEST(BoardMemory, SetsEveryLengthFromAllAlignments) {
  for (std::size_t to = 0; to < 8; ++to)
    for (std::size_t count = 0; count <= room - 8; ++count) {
      Bytes memory = numbered(4);
      Bytes expected = memory;
      for (std::size_t i = 0; i < count; ++i) expected[to + i] = 0xA5;
      ASSERT_EQ(board_memset(&memory[to], 0x1A5, count), &memory[to]);
      ASSERT_EQ(memory, expected) << to << ' ' << count;
    }
}

TEST(BoardMemory, ComparesAsUnsignedBytesFromTheFront) {
  const Bytes a{1, 2, 200, 4};
  const Bytes b{1, 2, 100, 9};
  EXPECT_GT(board_memcmp(a.data(), b.data(), 4), 0);
  EXPECT_LT(board_memcmp(b.data(), a.data(), 4), 0);
  EXPECT_EQ(board_memcmp(a.data(), b.data(), 2), 0);
  EXPECT_EQ(board_memcmp(a.data(), b.data(), 0), 0);
}

}  // namespace
