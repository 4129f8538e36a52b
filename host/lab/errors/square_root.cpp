// SPDX-License-Identifier: MIT
//
// Errors of square roots, against the C library's, which is exact in 64 bits for integers of 32.
#include <host/lab/errors/numbers.hpp>

#include <cmath>
#include <firmware/lab/families/square_root.hpp>

namespace {

struct SquareRootErrors {
  using Family = lab::SquareRoot;
  using Case = std::array<std::int64_t, 1>;

  template <class Visit>
  static std::string cases(int load, host::lab::Effort effort, Visit&& visit) {
    visit(Case{0});
    if (load == 0) {
      host::lab::visit_numbers(effort.random(10'000'000), visit);
      return std::string("0, ") + host::lab::visited_numbers;
    }
    for (std::int64_t n = 1; n < (load == 1 ? 65536 : 1024); ++n) visit(Case{n});
    return load == 1 ? "all 65,536 numbers" : "all 1,024 numbers";
  }
  template <class R>
  static long double error(int /*load*/, const Case& c) {
    const long double exact = std::floor(std::sqrt(static_cast<long double>(c[0])));
    return std::fabs(static_cast<long double>(R{}(static_cast<std::uint32_t>(c[0]))) - exact);
  }
};

}  // namespace

host::lab::FamilyReport host::lab::family_report() { return report<SquareRootErrors>(); }
