// SPDX-License-Identifier: MIT
//
// Errors of square roots, against the largest r with r*r <= n in 64 bits.
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
    if (load == 0 && effort.full()) {
      for (std::int64_t n = 1; n <= 0xFFFF'FFFF; ++n) visit(Case{n});
      return "all 2^32 numbers";
    }
    if (load == 0) {
      host::lab::visit_numbers(effort.random(10'000'000), visit);
      return std::string("0, ") + host::lab::visited_numbers;
    }
    for (std::int64_t n = 1; n < (load == 1 ? 65536 : 1024); ++n) visit(Case{n});
    return load == 1 ? "all 65,536 numbers" : "all 1,024 numbers";
  }
  template <class R>
  static long double error(int /*load*/, const Case& c) {
    const std::int64_t off = std::int64_t{R{}(static_cast<std::uint32_t>(c[0]))} - root_of(c[0]);
    return static_cast<long double>(off < 0 ? -off : off);
  }

 private:
  /// The exact root; begins at the last one, for most numbers come in order.
  static std::int64_t root_of(std::int64_t n) {
    static std::int64_t root = 0;
    const std::int64_t beyond = n - root * root;
    if (beyond < -1000 * root || beyond > 1000 * root)
      root = static_cast<std::int64_t>(std::sqrt(static_cast<double>(n)));
    while (root * root > n) --root;
    while ((root + 1) * (root + 1) <= n) ++root;
    return root;
  }
};

}  // namespace

host::lab::FamilyReport host::lab::family_report() { return report<SquareRootErrors>(); }
