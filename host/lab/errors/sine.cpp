// SPDX-License-Identifier: MIT
//
// Errors of sines, against the C library's in 113 bits.
#include <host/lab/errors/report.hpp>

#include <cmath>
#include <firmware/lab/families/sine.hpp>

namespace {

struct SineErrors {
  using Family = lab::Sine;
  using Case = std::array<std::int64_t, 1>;

  template <class Visit>
  static std::string cases(int load, host::lab::Effort /*effort*/, Visit&& visit) {
    const std::int64_t reach = load == 0 ? 32768 : 1092;
    for (std::int64_t steps = -reach; steps <= std::min<std::int64_t>(reach, 32767); ++steps)
      visit(Case{steps});
    return load == 0 ? "all 65,536 angles" : "all 2,185 angles";
  }
  template <class R>
  static long double error(int /*load*/, const Case& c) {
    constexpr long double pi = 3.14159265358979323846264338327950288L;
    const auto [steps] = c;
    const long double exact = std::sin(pi * static_cast<long double>(steps) / 32768) * 32768;
    const auto angle = intaglio::number::Angle::from_steps(static_cast<int>(steps));
    return std::fabs(static_cast<long double>(R{}(angle).raw()) - exact);
  }
};

}  // namespace

host::lab::FamilyReport host::lab::family_report() { return report<SineErrors>(); }
