// SPDX-License-Identifier: MIT
//
// Errors of reciprocals, against the quotient in 64 bits.
#include <host/lab/errors/report.hpp>

#include <cmath>
#include <firmware/lab/families/reciprocal.hpp>

namespace {

struct ReciprocalErrors {
  using Family = lab::Reciprocal;
  using Case = std::array<std::int64_t, 1>;

  template <class Visit>
  static std::string cases(int load, host::lab::Effort /*effort*/, Visit&& visit) {
    const std::int64_t last = load == 0 ? 65535 : 1023;
    for (std::int64_t d = 1; d <= last; ++d) visit(Case{d});
    return load == 0 ? "all 65,535 divisors" : "all 1,023 divisors";
  }
  template <class R>
  static long double error(int /*load*/, const Case& c) {
    const auto [d] = c;
    const std::int64_t exact = (std::int64_t{1} << 31) / d;
    const std::int64_t off = std::int64_t{R{}(static_cast<std::uint16_t>(d))} - exact;
    return std::fabs(static_cast<long double>(off) / static_cast<long double>(exact)) * 1e6L;
  }
};

}  // namespace

host::lab::FamilyReport host::lab::family_report() { return report<ReciprocalErrors>(); }
