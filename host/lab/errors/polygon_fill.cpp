// SPDX-License-Identifier: MIT
//
// Pixels that a polygon fill gets wrong, against winding numbers in 128 bits.
#include <host/lab/errors/report.hpp>
#include <tests/oracle/polygon.hpp>

#include <firmware/lab/families/polygon_fill.hpp>

namespace {

struct PolygonFillErrors {
  using Family = lab::PolygonFill;
  using Case = std::array<std::int64_t, 1>;  // the number that the polygon follows from

  template <class Visit>
  static std::string cases(int load, host::lab::Effort effort, Visit&& visit) {
    const std::int64_t count = effort.random(load == 2 ? 1'000 : 10'000);
    for (std::int64_t seed = 1; seed <= count; ++seed) visit(Case{seed});
    return "polygons of the numbers 1 to " + std::to_string(count);
  }
  template <class R>
  static long double error(int load, const Case& c) {
    const Family::Input polygon(load, static_cast<std::uint32_t>(c[0]));
    lab::clear_canvas();
    const auto picture = lab::canvas();
    const auto bounds = picture.bounds();
    if (Family::run<R>(polygon) != 1) return bounds.width * bounds.height;
    const auto vertices = polygon.vertices();
    const oracle::Contours contours{{vertices.begin(), vertices.end()}};
    int wrong = 0;
    for (int y = 0; y < bounds.height; ++y) {
      const auto turns = oracle::winding_row(contours, 0, bounds.width, y);
      for (int x = 0; x < bounds.width; ++x) {
        const bool inside = turns[static_cast<std::size_t>(x)] % 2 != 0;
        if (inside != (picture.get(x, y) != 0)) ++wrong;
      }
    }
    return wrong;
  }
};

}  // namespace

host::lab::FamilyReport host::lab::family_report() { return report<PolygonFillErrors>(); }
