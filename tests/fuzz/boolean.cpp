// SPDX-License-Identifier: MIT
//
// Polygons combined, both ways: exact areas, tidy contours, and workspaces that say what they need.
#include <tests/clip/combine.hpp>
#include <tests/fuzz/input.hpp>

namespace fuzz {
namespace {

using intaglio::clip::boolean_limit;

tests::Shape shape(Input& in, int grid) {
  tests::Shape result(static_cast<std::size_t>(in.choice(3)));
  for (auto& contour : result) {
    contour.resize(static_cast<std::size_t>(in.choice(9)));
    for (auto& p : contour) {
      const auto coordinate = [&] {
        const int b = in.byte();
        // A small grid makes vertices, edges and crossings meet.
        if (b < 0xF0) return b % 8 * grid;
        return b < 0xF8 ? in.medium() * 16 : in.edge(boolean_limit);
      };
      p.x = coordinate();
      p.y = coordinate();
    }
  }
  return result;
}

bool in_domain(const tests::Shape& shape) {
  for (const auto& contour : shape)
    for (const auto p : contour)
      if (p.x < -boolean_limit || p.x > boolean_limit || p.y < -boolean_limit || p.y > boolean_limit)
        return false;
  return true;
}

}  // namespace

void run(Input in) {
  const int kind = in.byte();
  const auto rule = static_cast<tests::BooleanRule>(kind % 16 == 15 ? 4 : kind % 4);
  const int grid = kind < 0x80 ? 1 : 173;
  const tests::Shape a = shape(in, grid);
  const tests::Shape b = shape(in, grid);
  const tests::Combined result = tests::combined(rule, a, b);
  const bool good = in_domain(a) && in_domain(b) && rule <= tests::BooleanRule::b_minus_a;
  require(result.status.ok() == good, "combine refuses good polygons, or takes bad ones");
  if (!good) return;
  require(result.area() == tests::exact_area(rule, a, b), "combine: another area");
  for (const auto& contour : result.contours) {
    const std::size_t n = contour.size();
    require(n >= 3, "combine: a contour of less than three vertices");
    for (std::size_t i = 0; i < n; ++i) {
      const auto& p = contour[i];
      const auto& q = contour[(i + 1) % n];
      const auto& r = contour[(i + 2) % n];
      require((q.x - p.x) * (r.y - q.y) != (q.y - p.y) * (r.x - q.x), "combine: a vertex that is no corner");
    }
  }
  // Where the operands don't touch, the other way to the same set.
  const tests::Combined walk = tests::walked(rule, a, b);
  if (walk.status == intaglio::Status{intaglio::Error::unsupported, intaglio::Argument::vertices}) return;
  require(walk.status.ok(), "combine_greiner_hormann refuses good polygons");
  require(oracle::combined_area(walk.contours, {}, [](bool in_it, bool) { return in_it; }) == result.area(),
          "combine_greiner_hormann: another area");
}

}  // namespace fuzz
