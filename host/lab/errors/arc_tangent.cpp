// SPDX-License-Identifier: MIT
//
// Errors of arc tangents, against the C library's.
#include <host/lab/errors/report.hpp>

#include <cmath>
#include <firmware/lab/families/arc_tangent.hpp>
#include <limits>
#include <random>

namespace {

struct ArcTangentErrors {
  using Family = lab::ArcTangent;
  using Case = std::array<std::int64_t, 2>;

  template <class Visit>
  static std::string cases(int load, host::lab::Effort effort, Visit&& visit) {
    if (load == 1) {
      for (std::int64_t y = -240; y <= 240; ++y) {
        for (std::int64_t x = -320; x <= 320; x += effort.stride(7)) visit(Case{x, y});
      }
      return effort.full() ? "all 308,321 directions" : "every seventh direction";
    }
    // All quotients of 15 bits, the ends of the range, and lengths of all bits: random, and such that a shift
    // drops the most.
    for (std::int64_t y = 0; y <= 32768; ++y) visit(Case{32768, y});
    constexpr std::int64_t least = std::numeric_limits<std::int32_t>::min();
    for (const std::int64_t x : {least, least + 1, std::int64_t{-1}, std::int64_t{0}, -least - 1}) {
      for (const std::int64_t y : {least, least + 1, std::int64_t{1}, std::int64_t{0}, -least - 1}) {
        visit(Case{x, y});
      }
    }
    std::mt19937 engine(20261126);
    const std::int64_t points = effort.random(10'000'000);
    for (std::int64_t i = 0; i < points; ++i) {
      const auto any = [&] { return static_cast<std::int64_t>(static_cast<std::int32_t>(engine())); };
      const std::int64_t x = any();
      const std::int64_t y = any();
      const int shift = static_cast<int>(i % 29);
      const std::int64_t dropped = 32768 + (x & 15) + 1;
      visit(i % 4 == 0 ? Case{(dropped << 15) - 1, (dropped << 15) * (y & 65535) / 65536 + (x & 1)}
                       : Case{x >> shift, y >> shift});
    }
    return "all quotients of 15 bits, ends of the range, random (mt19937, seed 20261126)";
  }
  template <class R>
  static long double error(int /*load*/, const Case& c) {
    constexpr long double pi = 3.14159265358979323846264338327950288L;
    const auto [x, y] = c;
    const int steps = R{}(static_cast<std::int32_t>(x), static_cast<std::int32_t>(y)).steps();
    const long double exact =
        std::atan2(static_cast<long double>(y), static_cast<long double>(x)) * (32768 / pi);
    return std::fabs(std::remainder(static_cast<long double>(steps) - exact, 65536.0L));
  }
};

}  // namespace

host::lab::FamilyReport host::lab::family_report() { return report<ArcTangentErrors>(); }
