// SPDX-License-Identifier: MIT
//
// How far the ends of clipped lines are from where they are exactly, in pixels. Where only one of rung and
// oracle finds anything: how far its ends are from their middle.
#include <host/lab/errors/report.hpp>
#include <tests/oracle/line_window.hpp>

#include <cmath>
#include <firmware/lab/families/line_clip.hpp>
#include <random>

namespace {

using intaglio::linear::SubPoint;

struct LineClipErrors {
  using Family = lab::LineClip;
  using Case = std::array<std::int64_t, 4>;  // the ends, in 1/256 pixel

  template <class Visit>
  static std::string cases(int load, host::lab::Effort effort, Visit&& visit) {
    std::mt19937_64 random(1);
    const auto between = [&](std::int64_t first, std::int64_t last) {
      return first + static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(last - first + 1));
    };
    constexpr std::int64_t middle_x = 160 * 256;
    constexpr std::int64_t middle_y = 120 * 256;
    const std::int64_t most = std::int64_t{Family::reach[load]} * 256;
    const auto inside = [&](std::int64_t c) { return std::clamp<std::int64_t>(c, -limit, limit); };
    const auto line = [&](std::int64_t x0, std::int64_t y0, std::int64_t x1, std::int64_t y1) {
      visit(Case{inside(x0), inside(y0), inside(x1), inside(y1)});
    };
    const std::int64_t count = effort.random(5'000'000);
    for (std::int64_t i = 0; i < count; ++i) {
      const std::int64_t x = between(-most, most);
      const std::int64_t y = between(-most, most);
      switch (i % 4) {
        case 0:  // anywhere
          line(middle_x + x, middle_y + y, middle_x + between(-most, most), middle_y + between(-most, most));
          break;
        case 1:  // through a corner, or just past it
          line(x, y, between(-2, 2) - x, between(-2, 2) - y);
          break;
        case 2:  // along a diagonal, as long as can be
          line(middle_x - most + between(0, 999), middle_y - most + between(0, 999),
               middle_x + most - between(0, 999), middle_y + most - between(0, 999));
          break;
        default:  // through the middle
          line(middle_x + x, middle_y + y, middle_x - x + between(-20'000, 20'000),
               middle_y - y + between(-20'000, 20'000));
      }
    }
    return std::to_string(count) +
           " random lines (mt19937_64, seed 1), of four one through a corner and one as long as can be";
  }

  template <class R>
  static long double error(int /*load*/, const Case& c) {
    const SubPoint a{static_cast<int>(c[0]), static_cast<int>(c[1])};
    const SubPoint b{static_cast<int>(c[2]), static_cast<int>(c[3])};
    const auto& window = Family::window;
    const auto part = oracle::inside_part(a, b, window.x, window.y, window.right(), window.bottom());
    const auto ends = R{}(a, b, window).value();
    const auto place = [&](std::int64_t n, std::int64_t d) {
      const long double t = static_cast<long double>(n) / static_cast<long double>(d);
      return std::array<long double, 2>{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
    };
    const auto found = [](SubPoint p) { return std::array<long double, 2>{1.0L * p.x, 1.0L * p.y}; };
    const auto distance = [](const auto& p, const auto& q) {
      return std::hypot(p[0] - q[0], p[1] - q[1]) / 256;
    };
    const auto from = place(part.enter_n, part.enter_d);
    const auto to = place(part.leave_n, part.leave_d);
    if (part.visible && ends.visible)
      return std::max(distance(from, found(ends.from)), distance(to, found(ends.to)));
    if (part.visible) return distance(from, to) / 2;
    return ends.visible ? distance(found(ends.from), found(ends.to)) / 2 : 0;
  }

 private:
  static constexpr std::int64_t limit = std::int64_t{1} << 28;
};

}  // namespace

host::lab::FamilyReport host::lab::family_report() { return report<LineClipErrors>(); }
