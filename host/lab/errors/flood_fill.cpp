// SPDX-License-Identifier: MIT
//
// Pixels that a flood fill gets wrong, against a breadth-first search.
#include <host/lab/errors/report.hpp>
#include <tests/oracle/flood.hpp>

#include <firmware/lab/families/flood_fill.hpp>

namespace {

struct FloodFillErrors {
  using Family = lab::FloodFill;
  using Case = std::array<std::int64_t, 1>;  // the chamber

  template <class Visit>
  static std::string cases(int /*load*/, host::lab::Effort effort, Visit&& visit) {
    const std::int64_t chambers = effort.full() ? 16 : 2;
    for (std::int64_t i = 0; i < chambers; ++i) visit(Case{i});
    return std::to_string(chambers) + " chambers";
  }
  template <class R>
  static long double error(int load, const Case& c) {
    Family::prepare(load);
    const auto in = Family::input(load, static_cast<int>(c[0]));
    if (Family::run<R>(in) != 1) return Family::width * Family::height;
    const auto picture = lab::canvas();
    const auto bounds = picture.bounds();
    const auto reached = oracle::region(bounds.width, bounds.height, in.chamber, false, in.seed.x, in.seed.y,
                                        [&](int x, int y) { return !Family::is_wall(load, x, y); });
    int wrong = 0;
    for (int y = 0; y < bounds.height; ++y) {
      for (int x = 0; x < bounds.width; ++x) {
        const bool filled = picture.get(x, y) == 1;
        if (filled != (reached[static_cast<std::size_t>(y * bounds.width + x)] != 0)) ++wrong;
      }
    }
    return wrong;
  }
};

}  // namespace

host::lab::FamilyReport host::lab::family_report() { return report<FloodFillErrors>(); }
