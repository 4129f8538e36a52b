// SPDX-License-Identifier: MIT
//
// Rows on which an edge stands at the wrong pixel, of a million, against a division in 128 bits on each.
#include <host/lab/errors/report.hpp>
#include <tests/oracle/integer.hpp>

#include <firmware/lab/families/edge.hpp>
#include <random>

namespace {

struct EdgeErrors {
  using Family = lab::Edge;
  using Case = std::array<std::int64_t, 4>;  // the upper and the lower end, in 1/256 pixel

  template <class Visit>
  static std::string cases(int load, host::lab::Effort effort, Visit&& visit) {
    std::mt19937_64 random(1);
    const auto between = [&](std::int64_t first, std::int64_t last) {
      return first + static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(last - first + 1));
    };
    const std::int64_t one = std::int64_t{1} << Family::fraction_bits[load];
    const std::int64_t unit = 256 / one;
    const std::int64_t rows = Family::most_rows[load];
    const auto edge = [&](std::int64_t x, std::int64_t y, std::int64_t dx, std::int64_t dy) {
      visit(Case{x * unit, y * unit, (x + dx) * unit, (y + dy) * unit});
    };
    // Slopes near ratios of small numbers, where many rows pass close to a whole column.
    const std::int64_t tries = effort.full() ? 16 : 4;
    for (std::int64_t q = 1; q <= 24; ++q) {
      for (std::int64_t p = -q; p <= q; ++p) {
        for (std::int64_t i = 0; i < tries; ++i) {
          const std::int64_t dy = (rows * one - between(0, one - 1)) / q * q;
          const std::int64_t beside = i % 4 < 2 ? 0 : between(-2, 2);
          const std::int64_t x = i % 2 == 0 ? 0 : between(-one, one);
          if (dy > (rows - 1) * one) edge(x, i % 4 == 0 ? 0 : between(0, one - 1), dy / q * p + beside, dy);
        }
      }
    }
    // Tall edges that lean by less than a column.
    if (load == 2) edge(0, 183, 2, 262'132), edge(0, 123, 1, 262'107);
    const std::int64_t count = effort.random(240'000'000 / rows);
    for (std::int64_t i = 0; i < count; ++i) {
      const std::int64_t x = between(0, 320 * one);
      edge(x, between(0, one - 1), between(0, 320 * one) - x, rows * one - between(0, one - 1));
    }
    return "slopes near ratios of small numbers, and " + std::to_string(count) +
           " random edges (mt19937_64, seed 1)";
  }

  template <class R>
  static long double error(int /*load*/, const Case& c) {
    const auto [x0, y0, x1, y1] = c;
    const auto row_of = [](std::int64_t y) { return static_cast<int>(oracle::ceil_quotient(y, 256)); };
    const int begin = row_of(y0);
    const int end = row_of(y1);
    R rung;
    rung.start({static_cast<int>(x0), static_cast<int>(y0)}, {static_cast<int>(x1), static_cast<int>(y1)},
               begin);
    int wrong = 0;
    for (int row = begin; row < end; ++row) {
      // x0 + (x1 - x0) * (256 * row - y0) / (y1 - y0), over 256, rounded up.
      const oracle::Wide height = y1 - y0;
      const oracle::Wide place =
          oracle::Wide{x0} * height + oracle::Wide{x1 - x0} * (std::int64_t{256} * row - y0);
      if (oracle::ceil_quotient(place, 256 * height) != rung.x()) ++wrong;
      rung.next();
    }
    return 1e6L * wrong / (end - begin);
  }
};

}  // namespace

host::lab::FamilyReport host::lab::family_report() { return report<EdgeErrors>(); }
