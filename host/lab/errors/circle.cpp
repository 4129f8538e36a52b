// SPDX-License-Identifier: MIT
//
// Pixels that a circle gets wrong, against its definition in 128 bits.
#include <host/lab/errors/pixel_sink.hpp>
#include <host/lab/errors/report.hpp>
#include <tests/oracle/circle.hpp>

#include <firmware/lab/families/circle.hpp>

namespace {

struct CircleErrors {
  using Family = lab::Circle;
  using Case = std::array<std::int64_t, 3>;  // centre and radius

  template <class Visit>
  static std::string cases(int load, host::lab::Effort effort, Visit&& visit) {
    if (load < 2) {
      for (int radius = load == 0 ? 0 : 17; radius <= (load == 0 ? 16 : 119); ++radius)
        visit(Case{160, 120, radius});
      return load == 0 ? "all radii from 0 to 16" : "all radii from 17 to 119";
    }
    // Where the middle of the window meets the circle.
    const std::int64_t step = effort.stride(21);
    for (std::int64_t y = -1000; y <= 1000; y += step) {
      const int x = oracle::floor_root(1'000'000 - y * y);
      visit(Case{160 - x, 120 + y, 1000});
      visit(Case{160 + x, 120 + y, 1000});
    }
    return "one place of the window for " + std::string(step == 1 ? "each" : "one row of 21") +
           " row and side";
  }
  template <class R>
  static long double error(int /*load*/, const Case& c) {
    static host::lab::Pixels drawn;
    drawn.clear();
    const intaglio::linear::Rect window{0, 0, 320, 240};
    const host::lab::PixelSink sink(window, drawn);
    const auto radius = static_cast<int>(c[2]);
    if (!R{}(sink, {static_cast<int>(c[0]), static_cast<int>(c[1])}, radius).ok())
      return window.width * window.height;
    host::lab::Pixels expected;
    for (const auto& run : oracle::circle_runs(radius)) {
      for (int x = run.begin; x < run.end; ++x) {
        const std::int64_t column = c[0] + x;
        const std::int64_t row = c[1] + run.y;
        if (column >= 0 && column < window.width && row >= 0 && row < window.height)
          expected.emplace_back(static_cast<int>(row), static_cast<int>(column));
      }
    }
    return host::lab::differences(drawn, expected);
  }
};

}  // namespace

host::lab::FamilyReport host::lab::family_report() { return report<CircleErrors>(); }
