// SPDX-License-Identifier: MIT
//
// Pixels that a fill of convex polygons gets wrong, against winding numbers in 128 bits.
#include <host/lab/errors/filled_polygon.hpp>
#include <host/lab/errors/report.hpp>

#include <firmware/lab/families/convex_fill.hpp>

namespace {

struct ConvexFillErrors {
  using Family = lab::ConvexFill;
  using Case = std::array<std::int64_t, 1>;  // the number that the polygon follows from

  template <class Visit>
  static std::string cases(int load, host::lab::Effort effort, Visit&& visit) {
    const std::int64_t count = effort.random(load == 1 ? 3'000 : 10'000);
    for (std::int64_t seed = 1; seed <= count; ++seed) visit(Case{seed});
    return "octagons of the numbers 1 to " + std::to_string(count);
  }
  template <class R>
  static long double error(int load, const Case& c) {
    const Family::Input polygon(load, static_cast<std::uint32_t>(c[0]));
    return host::lab::wrong_pixels<Family, R>(polygon);
  }
};

}  // namespace

host::lab::FamilyReport host::lab::family_report() { return report<ConvexFillErrors>(); }
