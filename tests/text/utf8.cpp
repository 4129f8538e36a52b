// SPDX-License-Identifier: MIT
#include <intaglio/text/utf8.hpp>
#include <tests/oracle/utf8.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <memory>
#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace {

using intaglio::text::take_code_point;

std::vector<std::uint32_t> decode(std::string_view text) {
  std::vector<std::uint32_t> codes;
  while (!text.empty()) codes.push_back(take_code_point(text));
  return codes;
}

std::string hex(std::string_view bytes) {
  std::string out;
  for (const char c : bytes) {
    constexpr std::string_view digits = "0123456789abcdef";
    out += digits[static_cast<unsigned char>(c) / 16];
    out += digits[static_cast<unsigned char>(c) % 16];
  }
  return out;
}

/// Both decode in exactly as many bytes as there are: the text is copied to memory of its very size, so that
/// a sanitizer sees any read past the end.
bool agrees(std::string_view bytes) {
  const std::unique_ptr<char[]> exact(new char[bytes.size()]);
  bytes.copy(exact.get(), bytes.size());
  return decode({exact.get(), bytes.size()}) == oracle::utf8_by_definition().decode(bytes);
}

char byte(unsigned value) { return static_cast<char>(static_cast<unsigned char>(value)); }

TEST(Utf8, EveryScalarValueDecodesToItself) {
  for (std::uint32_t code = 0; code <= 0x10FFFF; ++code) {
    if (code >= 0xD800 && code <= 0xDFFF) continue;
    const std::string bytes = oracle::encode_utf8(code);
    std::string_view rest = bytes;
    if (take_code_point(rest) != code || !rest.empty()) FAIL() << hex(bytes);
  }
}

TEST(Utf8, AllOneAndTwoByteStringsAgreeWithTheOracle) {
  for (unsigned a = 0; a < 256; ++a) {
    ASSERT_TRUE(agrees(std::string{byte(a)})) << a;
    for (unsigned b = 0; b < 256; ++b) {
      const std::string bytes{byte(a), byte(b)};
      if (!agrees(bytes)) FAIL() << hex(bytes);
    }
  }
}

// Below 0xC0 a lead byte stands alone whatever follows (the two-byte strings have it), so three bytes are
// tried for all leads from 0xBF on.
TEST(Utf8, AllThreeByteStringsWithALeadAgreeWithTheOracle) {
  for (unsigned a = 0xBF; a < 256; ++a)
    for (unsigned b = 0; b < 256; ++b)
      for (unsigned c = 0; c < 256; ++c) {
        const std::string bytes{byte(a), byte(b), byte(c)};
        if (!agrees(bytes)) FAIL() << hex(bytes);
      }
}

// Four bytes: all leads and second bytes; for the third and fourth both sides of every border of table 3-7.
TEST(Utf8, FourByteStringsAgreeWithTheOracle) {
  constexpr std::array borders{0x00U, 0x7FU, 0x80U, 0x8FU, 0x90U, 0x9FU, 0xA0U, 0xBFU, 0xC0U,
                               0xC2U, 0xDFU, 0xE0U, 0xEDU, 0xF0U, 0xF4U, 0xF5U, 0xFFU};
  for (unsigned a = 0xDF; a < 256; ++a)
    for (unsigned b = 0; b < 256; ++b)
      for (const unsigned c : borders)
        for (const unsigned d : borders) {
          const std::string bytes{byte(a), byte(b), byte(c), byte(d)};
          if (!agrees(bytes)) FAIL() << hex(bytes);
        }
}

TEST(Utf8, RandomBytesAgreeWithTheOracle) {
  constexpr unsigned seed = 8;
  std::mt19937 random(seed);
  for (int round = 0; round < 20000; ++round) {
    std::string bytes;
    const auto length = random() % 24;
    for (unsigned i = 0; i < length; ++i) {
      // Mostly bytes from 0x80 on: plain ASCII finds nothing.
      bytes += byte(random() % 4 == 0 ? random() % 256 : 0x80 + random() % 128);
    }
    if (!agrees(bytes)) FAIL() << "seed " << seed << ": " << hex(bytes);
  }
}

TEST(Utf8, OneReplacementForEachMaximalSubpart) {
  EXPECT_EQ(decode("\xF0\x80\x80"), (std::vector<std::uint32_t>{0xFFFD, 0xFFFD, 0xFFFD}));
  EXPECT_EQ(decode("\xE2\x82"), (std::vector<std::uint32_t>{0xFFFD}));  // a euro sign cut off
  EXPECT_EQ(decode("\xE2\x82"
                   "A"),
            (std::vector<std::uint32_t>{0xFFFD, 'A'}));
  EXPECT_EQ(decode("\xC0\xAF"), (std::vector<std::uint32_t>{0xFFFD, 0xFFFD}));              // overlong slash
  EXPECT_EQ(decode("\xED\xA0\x80"), (std::vector<std::uint32_t>{0xFFFD, 0xFFFD, 0xFFFD}));  // surrogate
  EXPECT_EQ(decode("\xF4\x90\x80\x80"), (std::vector<std::uint32_t>{0xFFFD, 0xFFFD, 0xFFFD, 0xFFFD}));
}

}  // namespace
