// SPDX-License-Identifier: MIT
//
// Pixels that an ellipse gets wrong, against its definition in 128 bits.
#include <host/lab/errors/pixel_sink.hpp>
#include <host/lab/errors/report.hpp>
#include <tests/oracle/oval.hpp>

#include <firmware/lab/families/ellipse.hpp>

namespace {

struct EllipseErrors {
  using Family = lab::Ellipse;
  using Case = std::array<std::int64_t, 4>;  // centre and half axes

  template <class Visit>
  static std::string cases(int load, host::lab::Effort effort, Visit&& visit) {
    if (load < 2) {
      const int least = load == 0 ? 1 : 16;
      const int most = load == 0 ? 15 : 119;
      const auto step = static_cast<int>(load == 0 ? 1 : effort.stride(13));
      for (int a = least; a <= most; a += step) {
        for (int b = least; b <= most; b += step) visit(Case{160, 120, a, b});
      }
      return (step == 1 ? "all half axes from " : "one of 169 half axes from ") + std::to_string(least) +
             " to " + std::to_string(most);
    }
    const std::int64_t step = effort.stride(13);
    for (std::int64_t across = 300; across <= 450; across += step) {
      for (std::int64_t down = 300; down <= 450; down += step)
        visit(Case{160, (across + down) % 2 == 0 ? 500 : 120 - down, across, down});
    }
    return (step == 1 ? "all" : "one of 169") + std::string(" half axes from 300 to 450, above or below");
  }
  template <class R>
  static long double error(int /*load*/, const Case& c) {
    static host::lab::Pixels drawn;
    drawn.clear();
    const intaglio::linear::Rect window{0, 0, 320, 240};
    const host::lab::PixelSink sink(window, drawn);
    const auto a = static_cast<int>(c[2]);
    const auto b = static_cast<int>(c[3]);
    if (!R{}(sink, {static_cast<int>(c[0]), static_cast<int>(c[1])}, a, b).ok())
      return window.width * window.height;
    host::lab::Pixels expected;
    // A pixel of the oval is on its outline if a neighbour is outside; rows are as wide as they reach.
    const auto reach = [&](std::int64_t y) {
      return std::abs(y) > b ? -1 : oracle::oval_reach(2 * a, 2 * b, static_cast<int>(2 * y)) / 2;
    };
    for (int row = 0; row < window.height; ++row) {
      const std::int64_t y = row - c[1];
      const int out = std::abs(y) > b ? -1 : reach(y);
      if (out < 0) continue;
      // The row further out is the shorter one.
      const int beyond = reach(std::abs(y) + 1);
      for (int x = std::min(out, beyond + 1); x <= out; ++x) {
        for (const int side : {-x, x}) {
          const std::int64_t column = c[0] + side;
          if (column >= 0 && column < window.width) expected.emplace_back(row, static_cast<int>(column));
        }
      }
    }
    return host::lab::differences(drawn, expected);
  }
};

}  // namespace

host::lab::FamilyReport host::lab::family_report() { return report<EllipseErrors>(); }
