// SPDX-License-Identifier: MIT
//
// Errors of vectors brought to length one: of the worst component, against the C library's root.
#include <host/lab/errors/report.hpp>

#include <cmath>
#include <firmware/lab/families/normalise.hpp>
#include <random>

namespace {

struct NormaliseErrors {
  using Family = lab::Normalise;
  using Case = std::array<std::int64_t, 3>;

  template <class Visit>
  static std::string cases(int load, host::lab::Effort effort, Visit&& visit) {
    std::mt19937 engine(20261127);
    const auto within = [&](std::int64_t reach) {
      return static_cast<std::int64_t>(engine() % static_cast<std::uint32_t>(2 * reach + 1)) - reach;
    };
    const std::int64_t points = effort.random(10'000'000);
    for (std::int64_t i = 0; i < points; ++i) {
      if (load == 0) {
        // One component of all sizes, the others as long or nearly along an axis.
        const std::int64_t reach = i % 4 == 1 ? 15 : 32767;
        const std::int64_t x = within(std::int64_t{32767} >> (i % 12));
        const std::int64_t y = within(reach);
        visit(Case{x, y, within(reach)});
        continue;
      }
      const std::int64_t x = within(16384);
      const std::int64_t y = within(16384);
      const std::int64_t z = within(16384);
      const std::int64_t square = x * x + y * y + z * z;
      if (square >= 1 << 27 && square <= 1 << 28) visit(Case{x, y, z});
    }
    return "random, also near axes (mt19937, seed 20261127)";
  }
  template <class R>
  static long double error(int /*load*/, const Case& c) {
    const auto [x, y, z] = c;
    if ((x | y | z) == 0) return 0;
    const auto in = [](std::int64_t value) { return static_cast<std::int16_t>(value); };
    const auto unit = R{}({in(x), in(y), in(z)});
    const long double length = std::sqrt(static_cast<long double>(x * x + y * y + z * z));
    long double worst = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const long double exact = static_cast<long double>(c[i]) / length * 32768;
      worst = std::max(worst, std::fabs(static_cast<long double>(unit[i].raw()) - exact));
    }
    return worst;
  }
};

}  // namespace

host::lab::FamilyReport host::lab::family_report() { return report<NormaliseErrors>(); }
