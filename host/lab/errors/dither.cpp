// SPDX-License-Identifier: MIT
//
// Errors of dithering: how far the mean level of 8x8 pixels is from the mean value, exactly.
#include <host/lab/errors/report.hpp>
#include <tests/oracle/dither.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <firmware/lab/families/dither.hpp>
#include <vector>

namespace {

constexpr int side = 40;

struct DitherErrors {
  using Family = lab::Dither;
  /// Levels, then: a value, what it grows by to the right and down over the picture; or kind and seed.
  using Case = std::array<std::int64_t, 4>;

  template <class Visit>
  static std::string cases(int load, host::lab::Effort effort, Visit&& visit) {
    constexpr std::array<std::int64_t, 5> level_counts{2, 3, 4, 8, 16};
    if (load == 0) {
      for (const auto levels : level_counts)
        for (std::int64_t value = 0; value < 256; ++value) visit(Case{levels, value, 0, 0});
      return "all 256 values, 5 numbers of levels";
    }
    if (load == 1) {
      const std::int64_t stride = effort.full() ? 3 : 51;
      for (std::int64_t from = 0; from < 256; from += stride)
        for (std::int64_t to = 0; to < 256; to += stride)
          for (std::int64_t down = 0; down < 256; down += 51)
            for (const std::int64_t levels : {2, 4}) visit(Case{levels, from, to - from, down - from});
      return "slopes between corners of all values in steps of 3";
    }
    // Values that the thresholds of a matrix just lift to the next level: kinds 1, 2, 3.
    for (std::int64_t kind = 1; kind <= 3; ++kind)
      for (std::int64_t levels = 2; levels <= 16; ++levels) visit(Case{levels, kind, 0, 0});
    const std::int64_t pictures = effort.random(100'000);
    for (std::int64_t seed = 0; seed < pictures; ++seed) visit(Case{2 + seed % 15, 0, seed, 0});
    return "pictures made against each matrix, and noise with seeds from 0 on";
  }

  static int value(int load, const Case& c, int x, int y, lab::Random& random) {
    if (load < 2) return std::clamp(static_cast<int>(c[1] + (c[2] * x + c[3] * y) / (side - 1)), 0, 255);
    if (c[1] == 0) {
      // Noise of every strength about every value.
      const int strength = static_cast<int>(c[2] % 5) * 64;
      return std::clamp(static_cast<int>(c[2] * 37 % 256) + random.between(-strength, strength), 0, 255);
    }
    const int matrix = 1 << c[1];
    const int place = oracle::bayer(x % matrix, y % matrix, matrix);
    const int steps = static_cast<int>(c[0]) - 1;
    const int lift = 255 * (2 * place + 1) / (2 * matrix * matrix);
    return (255 - lift + steps - 1) / steps;
  }

  template <class R>
  static double error(int load, const Case& c) {
    oracle::DitherPicture values{side, std::vector<int>(static_cast<std::size_t>(side * side))};
    lab::Random random(static_cast<std::uint32_t>(c[2]));
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x) values.pixels[values.at(x, y)] = value(load, c, x, y, random);
    oracle::DitherPicture levels = values;
    std::array<std::int16_t, side + 2> memory{};
    typename R::Walk walk(0, side, static_cast<int>(c[0]), memory);
    for (int y = 0; y < side; ++y) {
      const bool back = walk.begin_row(y);
      for (int i = 0; i < side; ++i) {
        const std::size_t at = values.at(back ? side - 1 - i : i, y);
        levels.pixels[at] = static_cast<int>(walk.next(static_cast<std::uint8_t>(values.pixels[at])));
      }
    }
    return oracle::worst_mean(values, levels, static_cast<int>(c[0]) - 1);
  }
};

}  // namespace

host::lab::FamilyReport host::lab::family_report() { return report<DitherErrors>(); }
