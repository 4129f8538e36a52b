// SPDX-License-Identifier: MIT
#include <host/draw/decimal.hpp>
#include <tests/oracle/random.hpp>

#include <climits>
#include <gtest/gtest.h>

#include <cstdint>
#include <optional>
#include <string>

namespace {

using host::draw::parse_subpixel;
using host::draw::parse_whole;

TEST(ParseWhole, TakesDigitsWithASignAndNothingElse) {
  EXPECT_EQ(parse_whole("0"), 0);
  EXPECT_EQ(parse_whole("-17"), -17);
  EXPECT_EQ(parse_whole("+0042"), 42);
  for (const char* bad : {"", "-", "+", "--1", "1.0", "1e3", "0x10", " 1", "1 ", "one", "\xD9\xA1"})
    EXPECT_EQ(parse_whole(bad), std::nullopt) << bad;
}

TEST(ParseWhole, SaturatesInsteadOfWrapping) {
  EXPECT_EQ(parse_whole("2147483647"), INT_MAX);
  EXPECT_EQ(parse_whole("2147483648"), INT_MAX);
  EXPECT_EQ(parse_whole("-99999999999999999999999999"), -INT_MAX);
}

TEST(ParseSubpixel, HalvesGoAwayFromZeroHoweverManyDigitsTellThemApart) {
  EXPECT_EQ(parse_subpixel("1"), 256);
  EXPECT_EQ(parse_subpixel("-1.5"), -384);
  EXPECT_EQ(parse_subpixel(".25"), 64);
  EXPECT_EQ(parse_subpixel("3."), 768);
  EXPECT_EQ(parse_subpixel("0.00390625"), 1);
  EXPECT_EQ(parse_subpixel("0.001953125"), 1);  // exactly half of 1/256
  EXPECT_EQ(parse_subpixel("-0.001953125"), -1);
  EXPECT_EQ(parse_subpixel("0.0019531249"), 0);
  EXPECT_EQ(parse_subpixel("0.001953124" + std::string(500, '9')), 0);
  EXPECT_EQ(parse_subpixel("0." + std::string(500, '9')), 256);
  EXPECT_EQ(parse_subpixel("-0.0"), 0);
  EXPECT_EQ(parse_subpixel("1048576"), 1 << 28);
  EXPECT_EQ(parse_subpixel("99999999999999999999.5"), INT_MAX);
  EXPECT_EQ(parse_subpixel("-2147483648"), -INT_MAX);
  for (const char* bad : {"", ".", "-", "-.", "1.2.3", "1,5", "1e3", "nan", "inf", "1.-5", "0x1.8"})
    EXPECT_EQ(parse_subpixel(bad), std::nullopt) << bad;
}

// nanosvg #292: -3E7.1442 became -30000000, times 1024 an int that it doesn't fit in.
TEST(ParseSubpixel, Nanosvg292ExponentsAreNoNumbers) {
  EXPECT_EQ(parse_subpixel("-3E7.1442"), std::nullopt);
  EXPECT_EQ(parse_subpixel("-3E7"), std::nullopt);
  EXPECT_EQ(parse_subpixel("-30000000.1442"), -INT_MAX);
  EXPECT_EQ(parse_whole("-3E7"), std::nullopt);
}

TEST(ParseSubpixel, TakesFractionsOfWholeNumbers) {
  EXPECT_EQ(parse_subpixel("7/3"), 597);  // 597.33
  EXPECT_EQ(parse_subpixel("-7/3"), -597);
  EXPECT_EQ(parse_subpixel("+5/2"), 640);
  EXPECT_EQ(parse_subpixel("6/3"), 512);
  EXPECT_EQ(parse_subpixel("0/5"), 0);
  EXPECT_EQ(parse_subpixel("1/512"), 1);  // exactly half of 1/256
  EXPECT_EQ(parse_subpixel("-1/512"), -1);
  EXPECT_EQ(parse_subpixel("1/513"), 0);
  EXPECT_EQ(parse_subpixel("1048576/1"), 1 << 28);
  EXPECT_EQ(parse_subpixel("99999999999999999999/1"), INT_MAX);
  EXPECT_EQ(parse_subpixel("-99999999999999999999/2"), -INT_MAX);
  EXPECT_EQ(parse_subpixel("1" + std::string(500, '0') + "/" + "2" + std::string(500, '0')), 128);
  EXPECT_EQ(parse_subpixel("1" + std::string(500, '0') + "/512" + std::string(500, '0')), 1);
  EXPECT_EQ(parse_subpixel("1" + std::string(500, '0') + "/512" + std::string(499, '0') + "1"), 0);
  for (const char* bad : {"/", "7/", "/3", "7/0", "7/-3", "7/+3", "7//3", "7/3/1", "7.5/3", "7/3.5", "-/3"})
    EXPECT_EQ(parse_subpixel(bad), std::nullopt) << bad;
  EXPECT_EQ(parse_whole("6/3"), std::nullopt);
}

// |256 * n/d - v| <= 1/2, and v further from zero where both sides are equal.
TEST(ParseSubpixel, IsTheNearest256thOfEveryFraction) {
  oracle::Random random(32);
  for (int round = 0; round < 20000; ++round) {
    const std::int64_t lower = random.between(1, round % 2 == 0 ? 2048 : INT_MAX);
    const std::int64_t upper = random.between(0, round % 3 == 0 ? 5000 : INT_MAX);
    const std::string text = std::to_string(upper) + "/" + std::to_string(lower);
    const std::optional<int> got = parse_subpixel(text);
    ASSERT_TRUE(got.has_value()) << text;
    const std::int64_t error = 2 * (256 * upper - *got * lower);  // in units of 1 / (2 * lower)
    const bool nearest = (error < lower && error >= -lower) || *got == INT_MAX;
    if (!nearest) FAIL() << random.seed_text() << ": " << text << " became " << *got;
    EXPECT_EQ(parse_subpixel("-" + text), -*got);
  }
}

// Nearest by definition: |256 * v - n| <= 1/2, and n further from zero where both sides are equal.
TEST(ParseSubpixel, IsTheNearest256thOfEveryDecimalWithUpToNineDigits) {
  oracle::Random random(31);
  for (int round = 0; round < 20000; ++round) {
    const int digits = random.between(1, 9);
    std::int64_t power = 1;
    for (int i = 0; i < digits; ++i) power *= 10;
    std::int64_t value = random.between(0, INT_MAX);  // value / power is the number
    if (round % 4 == 0 && digits == 9) value = (2 * (value / 3906250) + 1) * 1953125;  // halves
    std::string text = std::to_string(value);
    while (text.size() <= static_cast<std::size_t>(digits)) text.insert(0, 1, '0');
    text.insert(text.size() - static_cast<std::size_t>(digits), 1, '.');
    const std::optional<int> got = parse_subpixel(text);
    ASSERT_TRUE(got.has_value()) << text;
    const std::int64_t error = 2 * (256 * value - *got * power);  // in units of 1 / (2 * power)
    const bool nearest = (error < power && error >= -power) || (*got == INT_MAX);
    if (!nearest) FAIL() << random.seed_text() << ": " << text << " became " << *got;
    EXPECT_EQ(parse_subpixel("-" + text), -*got);
  }
}

}  // namespace
