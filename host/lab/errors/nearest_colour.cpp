// SPDX-License-Identifier: MIT
//
// Errors of nearest colours: how much further the chosen entry is than the best, in L*a*b* of real numbers.
#include <host/lab/errors/report.hpp>
#include <tests/oracle/lab.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <firmware/lab/families/nearest_colour.hpp>
#include <vector>

namespace {

struct NearestColourErrors {
  using Family = lab::NearestColour;
  using Case = std::array<std::int64_t, 3>;

  template <class Visit>
  static std::string cases(int /*load*/, host::lab::Effort effort, Visit&& visit) {
    const std::int64_t stride = effort.stride(4099);
    for (std::int64_t i = 0; i < 1 << 24; i += stride) visit(Case{i >> 16, i >> 8 & 255, i & 255});
    return stride == 1 ? "all 2^24 colours" : "every 4,099th of 2^24 colours";
  }
  template <class R>
  static double error(int load, const Case& c) {
    static const auto palettes = [] {
      std::array<std::vector<oracle::Lab>, 3> all;
      for (int of = 0; of < 3; ++of)
        for (int i = 0; i < Family::entries(of); ++i) {
          const auto rgb = Family::entry(of, i);
          all.at(static_cast<std::size_t>(of)).push_back(oracle::lab(rgb.r, rgb.g, rgb.b));
        }
      return all;
    }();
    const auto& palette = palettes.at(static_cast<std::size_t>(load));
    const oracle::Lab exact =
        oracle::lab(static_cast<int>(c[0]), static_cast<int>(c[1]), static_cast<int>(c[2]));
    double best = 1e9;
    for (const auto& entry : palette) best = std::min(best, oracle::squared_distance(entry, exact));
    const std::size_t chosen = R{}(
        Family::palette<R>(load),
        {static_cast<std::uint8_t>(c[0]), static_cast<std::uint8_t>(c[1]), static_cast<std::uint8_t>(c[2])});
    return std::sqrt(oracle::squared_distance(palette.at(chosen), exact)) - std::sqrt(best);
  }
};

}  // namespace

host::lab::FamilyReport host::lab::family_report() { return report<NearestColourErrors>(); }
