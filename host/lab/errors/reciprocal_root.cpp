// SPDX-License-Identifier: MIT
//
// Errors of reciprocal square roots: a guess of the C library's is moved to the largest r with r*r*n <= 2^62
// in 128 bits.
#include <host/lab/errors/numbers.hpp>

#include <cmath>
#include <firmware/lab/families/reciprocal_root.hpp>

namespace {

struct ReciprocalRootErrors {
  using Family = lab::ReciprocalRoot;
  using Case = std::array<std::int64_t, 1>;

  template <class Visit>
  static std::string cases(int load, host::lab::Effort effort, Visit&& visit) {
    if (load == 0) {
      host::lab::visit_numbers(effort.random(10'000'000), visit);
      return host::lab::visited_numbers;
    }
    std::mt19937 engine(20261124);
    constexpr std::int64_t least = std::int64_t{1} << 27;
    const std::int64_t points = effort.random(10'000'000);
    for (std::int64_t i = 0; i < points; ++i) visit(Case{least + static_cast<std::int64_t>(engine() >> 5U)});
    return "random (mt19937, seed 20261124)";
  }
  template <class R>
  static long double error(int /*load*/, const Case& c) {
    using Wide = __int128;
    constexpr Wide one = Wide{1} << 62;
    const Wide n = c[0];
    auto exact = static_cast<std::int64_t>(0x1p31L / std::sqrt(static_cast<long double>(c[0])));
    while (Wide{exact} * exact * n > one) --exact;
    while (Wide{exact + 1} * (exact + 1) * n <= one) ++exact;
    const std::int64_t off = std::int64_t{R{}(static_cast<std::uint32_t>(c[0]))} - exact;
    return std::fabs(static_cast<long double>(off) / static_cast<long double>(exact)) * 1e6L;
  }
};

}  // namespace

host::lab::FamilyReport host::lab::family_report() { return report<ReciprocalRootErrors>(); }
