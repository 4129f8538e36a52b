// SPDX-License-Identifier: MIT
//
// Pixels that a triangle gets wrong, against its edge functions in 128 bits.
#include <host/lab/errors/report.hpp>
#include <tests/oracle/polygon.hpp>

#include <firmware/lab/families/triangle.hpp>
#include <random>

namespace {

struct TriangleErrors {
  using Family = lab::Triangle;
  using Case = std::array<std::int64_t, 6>;  // three vertices, in 1/256 pixel

  template <class Visit>
  static std::string cases(int load, host::lab::Effort effort, Visit&& visit) {
    std::mt19937 random(1);
    const auto between = [&](std::int64_t first, std::int64_t last) {
      return first + static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(last - first + 1));
    };
    // Sides that all go through pixel centres but for a bit, along rows, columns and diagonals; slivers have
    // their short side along a row.
    const std::int64_t most = std::int64_t{Family::longest[load]} * 256;
    for (const std::int64_t long_side : {most, most - 1, most / 2}) {
      const std::int64_t side = std::min<std::int64_t>(long_side, 238 * 256);
      for (const std::int64_t off : {-128, -127, -8, -7, -1, 0, 1, 7, 8, 127, 128}) {
        const std::int64_t at = 256 + off;
        visit(Case{at, at, at + (load == 1 ? 512 : side), at, at, at + side});
        visit(Case{at, at, at + side, at, at, at + (load == 1 ? 512 : side)});
      }
    }
    const std::int64_t count = effort.random(load == 2 ? 10'000 : 100'000);
    for (std::int64_t i = 0; i < count; ++i) {
      const std::int64_t reach = most / 2;
      const std::int64_t x = between(40'000, 42'000);
      const std::int64_t y = between(30'000, 32'000);
      Case c{};
      for (std::size_t k = 0; k < 6; k += 2) {
        c[k] = x + between(-reach, reach);
        c[k + 1] = y + between(-reach, reach);
      }
      if (load == 1) {
        c[4] = c[2] + between(-500, 500);
        c[5] = c[3] + between(-500, 500);
      }
      visit(c);
    }
    return "sides through pixel centres but for a bit, and " + std::to_string(count) +
           " random triangles (mt19937, seed 1)";
  }

  template <class R>
  static long double error(int /*load*/, const Case& c) {
    Family::Input corners;
    for (std::size_t i = 0; i < 3; ++i)
      corners[i] = {static_cast<int>(c[2 * i]), static_cast<int>(c[2 * i + 1])};
    const intaglio::linear::Rect window{0, 0, 320, 240};
    // Rows have one span each, or none.
    static std::array<std::pair<int, int>, 240> rows;
    rows.fill({0, 0});
    if (!R{}(Rows{window, rows.data()}, corners[0], corners[1], corners[2]).ok())
      return window.width * window.height;
    int wrong = 0;
    std::array<std::pair<int, int>, 240> expected{};
    for (const auto& span : oracle::triangle_spans(corners[0], corners[1], corners[2], window))
      expected[static_cast<std::size_t>(span.y)] = {span.begin, span.end};
    for (std::size_t y = 0; y < rows.size(); ++y) {
      const auto [begin, end] = rows[y];
      const auto [true_begin, true_end] = expected[y];
      const int common = std::max(0, std::min(end, true_end) - std::max(begin, true_begin));
      wrong += end - begin + true_end - true_begin - 2 * common;
    }
    return wrong;
  }

 private:
  struct Rows {
    intaglio::linear::Rect window;
    std::pair<int, int>* rows;
    [[nodiscard]] const intaglio::linear::Rect& clip() const { return window; }
    void span(int y, int x_begin, int x_end) const { rows[y] = {x_begin, x_end}; }
  };
};

}  // namespace

host::lab::FamilyReport host::lab::family_report() { return report<TriangleErrors>(); }
