// SPDX-License-Identifier: MIT
#include <intaglio/image/blend_table.hpp>
#include <intaglio/image/palette.hpp>
#include <tests/oracle/random.hpp>
#include <tests/oracle/srgb.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace {

using intaglio::Argument;
using intaglio::Error;
using intaglio::Status;
using intaglio::image::BlendTable;
using intaglio::image::make_blend_row;
using intaglio::image::make_blend_table;

/// The distance, in sRGB codes, of an entry from the exact mixture of two others.
long double distance(const std::vector<std::uint8_t>& palette, int from, int to, int part, int whole,
                     int entry) {
  long double sum = 0;
  for (int channel = 0; channel < 3; ++channel) {
    const auto code = [&](int i) {
      return static_cast<long double>(palette.at(static_cast<std::size_t>(3 * i + channel)));
    };
    const long double light = (oracle::srgb_decode(code(from) / 255) * (whole - part) +
                               oracle::srgb_decode(code(to) / 255) * part) /
                              whole;
    const long double off = code(entry) - 255 * oracle::srgb_encode(light);
    sum += off * off;
  }
  return std::sqrt(sum);
}

TEST(BlendTable, HoldsThePalettesNearestColourToTheMixtureOfLight) {
  oracle::Random random(31);
  const long double slack = 2 * std::sqrt(3.0L) * 0.58L;
  for (const int entries : {2, 3, 16, 40}) {
    std::vector<std::uint8_t> palette(static_cast<std::size_t>(entries) * 3);
    for (auto& byte : palette) byte = static_cast<std::uint8_t>(random.bits());
    for (const int steps : {2, 3, 16, 17}) {
      const int index = random.between(0, entries - 1);
      std::vector<std::uint8_t> bytes(BlendTable::bytes(entries, steps));
      ASSERT_TRUE(make_blend_table(bytes, palette, index, steps).ok());
      const BlendTable table = BlendTable::over(bytes, entries, index, steps).value();
      long double worst = 0;
      for (int step = 1; step < steps - 1; ++step)
        for (int under = 0; under < entries; ++under) {
          long double best = std::numeric_limits<long double>::max();
          for (int entry = 0; entry < entries; ++entry)
            best = std::min(best, distance(palette, under, index, step, steps - 1, entry));
          const int chosen = table.row(step)[under];
          ASSERT_LT(chosen, entries);
          worst = std::max(worst, distance(palette, under, index, step, steps - 1, chosen) - best);
        }
      EXPECT_LE(worst, slack) << entries << " entries, " << steps << " steps, " << random.seed_text();
    }
  }
}

TEST(BlendTable, OnGreysIsMonotoneAndHitsTheMixtureItself) {
  std::vector<std::uint8_t> greys;
  for (int i = 0; i < 256; ++i) greys.insert(greys.end(), 3, static_cast<std::uint8_t>(i));
  std::vector<std::uint8_t> bytes(BlendTable::bytes(256, 5));
  ASSERT_TRUE(make_blend_table(bytes, greys, 255, 5).ok());
  const BlendTable table = BlendTable::over(bytes, 256, 255, 5).value();
  EXPECT_EQ(table.row(2)[0], 188);  // half the light of white
  EXPECT_EQ(table.row(1)[255], 255);
  for (int step = 1; step < 4; ++step)
    EXPECT_TRUE(std::is_sorted(table.row(step), table.row(step) + 256)) << step;
}

TEST(BlendTable, ByCodesHalfOfWhiteOverBlackIsTheMiddleCode) {
  std::vector<std::uint8_t> greys;
  for (int i = 0; i < 256; ++i) greys.insert(greys.end(), 3, static_cast<std::uint8_t>(i));
  std::vector<std::uint8_t> bytes(BlendTable::bytes(256, 256));
  for (const int index : {0, 77, 255}) {
    ASSERT_TRUE(make_blend_table(bytes, greys, index, 256, intaglio::image::BlendSpace::code).ok());
    const BlendTable table = BlendTable::over(bytes, 256, index, 256).value();
    int wrong = 0;
    for (int step = 1; step < 255; ++step)
      for (int under = 0; under < 256; ++under)
        wrong += table.row(step)[under] != (2 * ((255 - step) * under + step * index) + 255) / 510 ? 1 : 0;
    EXPECT_EQ(wrong, 0) << index;
  }
}

TEST(BlendTable, OfTwoAsNearTakesTheLower) {
  // Colours 1 and 2 are the same; nothing lies between 0 and them.
  const std::array<std::uint8_t, 9> palette{0, 0, 0, 255, 255, 255, 255, 255, 255};
  std::array<std::uint8_t, 3> bytes{9, 9, 9};
  ASSERT_TRUE(make_blend_table(bytes, palette, 2, 3).ok());
  EXPECT_EQ(bytes, (std::array<std::uint8_t, 3>{1, 1, 1}));
}

TEST(BlendTable, IsMadeAtCompileTimeToo) {
  static constexpr auto bytes = [] {
    constexpr std::array<std::uint8_t, 12> palette{0, 0, 0, 255, 0, 0, 188, 0, 0, 0, 0, 255};
    std::array<std::uint8_t, 4> made{};
    make_blend_table(made, palette, 1, 3).ignore();
    return made;
  }();
  static_assert(bytes == std::array<std::uint8_t, 4>{2, 1, 1, 2});
}

TEST(BlendTable, RowsMadeOneByOneAreTheTable) {
  oracle::Random random(32);
  std::vector<std::uint8_t> palette(3 * 20);
  for (auto& byte : palette) byte = static_cast<std::uint8_t>(random.bits());
  std::vector<std::uint8_t> whole(BlendTable::bytes(20, 9));
  ASSERT_TRUE(make_blend_table(whole, palette, 3, 9).ok());
  std::vector<std::uint8_t> rows;
  std::vector<std::uint8_t> row(20);
  const auto make = [&](int step, int steps) { return make_blend_row(row, palette, 3, step, steps); };
  for (int step = 1; step < 8; ++step) {
    ASSERT_TRUE(make(step, 9).ok());
    rows.insert(rows.end(), row.begin(), row.end());
  }
  EXPECT_EQ(rows, whole);
  for (const int bad : {0, 8, -1, INT32_MIN, INT32_MAX})
    EXPECT_EQ(make(bad, 9), (Status{Error::out_of_range, Argument::position}));
  EXPECT_EQ(make(1, 257), (Status{Error::out_of_range, Argument::steps}));
  row.resize(19);
  EXPECT_EQ(make(1, 9), (Status{Error::too_small, Argument::table, 20}));
}

TEST(BlendTable, BadArgumentsAreNamedAndNothingIsWritten) {
  std::vector<std::uint8_t> bytes(16 * 14, 77);
  std::vector<std::uint8_t> palette(48);
  const auto make = [&](int index, int steps) { return make_blend_table(bytes, palette, index, steps); };
  EXPECT_EQ(make(16, 16), (Status{Error::out_of_range, Argument::index}));
  EXPECT_EQ(make(-1, 16), (Status{Error::out_of_range, Argument::index}));
  for (const int steps : {1, 0, 257, INT32_MIN, INT32_MAX})
    EXPECT_EQ(make(1, steps), (Status{Error::out_of_range, Argument::steps}));
  EXPECT_EQ(make(1, 17), (Status{Error::too_small, Argument::table, 240}));
  for (const std::size_t size : {0U, 3U, 47U, 771U}) {
    palette.resize(size);
    EXPECT_EQ(make(0, 4), (Status{Error::malformed, Argument::palette}));
  }
  EXPECT_EQ(bytes, std::vector<std::uint8_t>(16 * 14, 77));
  EXPECT_EQ(BlendTable::over(bytes, 1, 0, 2).status(), (Status{Error::out_of_range, Argument::palette}));
  EXPECT_EQ(BlendTable::over({}, 2, 0, 2).value().steps(), 2);
}

}  // namespace
