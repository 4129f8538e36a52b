// SPDX-License-Identifier: MIT
//
// Errors of blends of 16 bits, against the quotient in floating point.
#include <host/lab/errors/report.hpp>

#include <cmath>
#include <firmware/lab/families/blend16.hpp>
#include <random>
#include <vector>

namespace {

struct Blend16Errors {
  using Family = lab::Blend16;
  using Case = std::array<std::int64_t, 3>;

  /// All triples of the neighbours of multiples of 2^12, and random ones.
  template <class Visit>
  static std::string cases(int load, host::lab::Effort effort, Visit&& visit) {
    std::vector<std::int64_t> edges;
    for (std::int64_t edge = 0; edge <= 65536; edge += 4096) {
      for (std::int64_t value = edge - 4; value <= edge + 4; ++value) {
        if (value >= 0 && value <= 65535) edges.push_back(value);
      }
    }
    for (const std::int64_t from : edges) {
      if (load == 1 && from > 0) break;
      for (const std::int64_t to : edges) {
        for (const std::int64_t alpha : edges) visit(Case{from, to, alpha});
      }
    }
    std::mt19937 engine(20261125);
    const std::int64_t points = effort.random(10'000'000);
    for (std::int64_t i = 0; i < points; ++i) {
      const auto value = [&] { return static_cast<std::int64_t>(engine() >> 16U); };
      const std::int64_t to = value();
      const std::int64_t alpha = value();
      visit(Case{load == 0 ? value() : 0, to, alpha});
    }
    return "neighbours of multiples of 4096, random (mt19937, seed 20261125)";
  }
  template <class R>
  static long double error(int /*load*/, const Case& c) {
    const auto [from, to, alpha] = c;
    const long double exact = static_cast<long double>(from * (65535 - alpha) + to * alpha) / 65535;
    const auto in = [](std::int64_t value) { return static_cast<std::uint16_t>(value); };
    return std::fabs(static_cast<long double>(R{}(in(from), in(to), in(alpha))) - exact);
  }
};

}  // namespace

host::lab::FamilyReport host::lab::family_report() { return report<Blend16Errors>(); }
