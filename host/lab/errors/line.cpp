// SPDX-License-Identifier: MIT
//
// Pixels that a line gets wrong, against a search for the nearest pixel in 128 bits.
#include <host/lab/errors/pixel_sink.hpp>
#include <host/lab/errors/report.hpp>
#include <tests/oracle/line.hpp>

#include <firmware/lab/families/line.hpp>
#include <random>

namespace {

using intaglio::linear::SubPoint;

struct LineErrors {
  using Family = lab::Line;
  using Case = std::array<std::int64_t, 4>;  // the ends, in 1/256 pixel

  static constexpr int width = 320;
  static constexpr int height = 240;

  template <class Visit>
  static std::string cases(int load, host::lab::Effort effort, Visit&& visit) {
    std::mt19937_64 random(1);
    const auto between = [&](std::int64_t first, std::int64_t last) {
      return first + static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(last - first + 1));
    };
    const auto whole = [&](std::int64_t x0, std::int64_t y0, std::int64_t x1, std::int64_t y1) {
      visit(Case{256 * x0, 256 * y0, 256 * x1, 256 * y1});
    };
    if (load <= 1) {
      // From B to A a line is what it is from A to B, and the same wherever it is.
      const std::int64_t across = load == 0 ? 15 : width - 1;
      const std::int64_t down = load == 0 ? 15 : height - 1;
      const std::int64_t step = load == 0 ? 1 : effort.stride(11);
      for (std::int64_t dx = 0; dx <= across; dx += step) {
        for (std::int64_t dy = -down; dy <= down; dy += step) whole(0, dy < 0 ? -dy : 0, dx, dy < 0 ? 0 : dy);
      }
      return step == 1 ? "all differences of two ends" : "one of 121 differences of two ends";
    }
    if (load == 2) {
      // Step k of M is just beside a tie: 2*m*k = M - d modulo 2*M.
      const std::int64_t count = effort.random(250'000);
      for (std::int64_t i = 0; i < count; ++i) {
        const std::int64_t major = between(Family::longest / 2, Family::longest);
        const std::int64_t minor = between(1, major - 1);
        const std::int64_t inverse = inverse_of(minor, major);
        std::int64_t d = between(-4, 4);
        if ((major - d) % 2 != 0) ++d;
        std::int64_t k = inverse == 0 ? between(0, major) : (major - d) / 2 % major * inverse % major;
        if (k < 0) k += major;
        const std::int64_t row = minor * k / major;
        if (i % 2 == 0)
          whole(160 - k, 120 - row, 160 - k + major, 120 - row + minor);
        else
          whole(160 - row, 120 + k, 160 - row + minor, 120 + k - major);
      }
      return std::to_string(count) + " lines with a visible pixel next to a tie (mt19937_64, seed 1)";
    }
    // Ends as far as can be from the middles of pixels, on lines along the diagonals.
    for (const int size : {1, 10, 100, height - 2}) {
      for (const int off : {-128, -127, -1, 0, 1, 126, 127}) {
        for (const int way : {-1, 1}) {
          const std::int64_t y0 = (way < 0 ? height - 1 : 1) * 256;
          visit(Case{256 + off, y0 - way * off, 256 * (size + 1) + off, y0 + way * (256 * size - off)});
        }
      }
    }
    const std::int64_t count = effort.random(200'000);
    for (std::int64_t i = 0; i < count; ++i) {
      visit(Case{between(0, 256 * (width - 1)), between(0, 256 * (height - 1)), between(0, 256 * (width - 1)),
                 between(0, 256 * (height - 1))});
    }
    return "diagonals, and " + std::to_string(count) + " random lines (mt19937_64, seed 1)";
  }

  template <class R>
  static long double error(int load, const Case& c) {
    const SubPoint from{static_cast<int>(c[0]), static_cast<int>(c[1])};
    const SubPoint to{static_cast<int>(c[2]), static_cast<int>(c[3])};
    static host::lab::Pixels drawn;
    drawn.clear();
    const host::lab::PixelSink sink({0, 0, width, height}, drawn);
    if (!Family::draw<R>(sink, Family::between(from, to)).ok()) return 2 * width;
    return host::lab::differences(drawn, expected(c, load == 3));
  }

 private:
  /// a with a * n = 1 modulo m; 0 if there is none.
  static std::int64_t inverse_of(std::int64_t n, std::int64_t m) {
    std::int64_t a = 1;
    std::int64_t b = 0;
    std::int64_t rest = m;
    while (rest != 0) {
      const std::int64_t quotient = n / rest;
      a -= quotient * b;
      std::swap(a, b);
      n -= quotient * rest;
      std::swap(n, rest);
    }
    return n == 1 ? (a % m + m) % m : 0;
  }

  static host::lab::Pixels expected(const Case& c, bool in_sub_pixels) {
    host::lab::Pixels pixels;
    const auto [x0, y0, x1, y1] = c;
    const bool steep = std::abs(y1 - y0) > std::abs(x1 - x0);
    for (int at = 0; at < (steep ? height : width); ++at) {
      if (in_sub_pixels) {
        // No search: a pixel of this column or row that is near the line.
        const std::int64_t along = steep ? y1 - y0 : x1 - x0;
        const std::int64_t from = steep ? y0 : x0;
        const std::int64_t minor = steep ? x0 : y0;
        const std::int64_t minor_way = steep ? x1 - x0 : y1 - y0;
        const std::int64_t near = along == 0 ? minor : minor + minor_way * (256 * at - from) / along;
        for (std::int64_t other = near / 256 - 2; other <= near / 256 + 2; ++other) {
          const std::int64_t x = steep ? other : at;
          const std::int64_t y = steep ? at : other;
          if (x >= 0 && x < width && y >= 0 && y < height && oracle::on_sub_line(x0, y0, x1, y1, x, y))
            pixels.emplace_back(y, x);
        }
      } else {
        const std::int64_t begin = (steep ? std::min(y0, y1) : std::min(x0, x1)) / 256;
        const std::int64_t end = (steep ? std::max(y0, y1) : std::max(x0, x1)) / 256;
        if (at < begin || at > end) continue;
        if (begin == end) {
          pixels.emplace_back(y0 / 256, x0 / 256);
          continue;
        }
        const bool turn = steep ? y0 > y1 : x0 > x1;
        const auto nearest = [&](std::int64_t major0, std::int64_t minor0, std::int64_t major1,
                                 std::int64_t minor1) {
          if (turn) std::swap(major0, major1), std::swap(minor0, minor1);
          return oracle::nearest_minor(major0 / 256, minor0 / 256, major1 / 256, minor1 / 256, at);
        };
        const std::int64_t x = steep ? nearest(y0, x0, y1, x1) : at;
        const std::int64_t y = steep ? at : nearest(x0, y0, x1, y1);
        if (x >= 0 && x < width && y >= 0 && y < height)
          pixels.emplace_back(static_cast<int>(y), static_cast<int>(x));
      }
    }
    return pixels;
  }
};

}  // namespace

host::lab::FamilyReport host::lab::family_report() { return report<LineErrors>(); }
