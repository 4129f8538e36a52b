// SPDX-License-Identifier: MIT
//
// By how much the area of a clipped polygon is off, against the exact area in rational numbers.
#include <host/lab/errors/report.hpp>
#include <tests/oracle/boolean.hpp>

#include <array>
#include <cmath>
#include <firmware/lab/families/polygon_clip.hpp>

namespace {

/// The area that lies inside, even-odd, in 1/65536 pixel.
mpq_class exact_area(const lab::WindowAndPolygon& input) {
  const auto contours = [](auto vertices) { return oracle::rational({{vertices.begin(), vertices.end()}}); };
  return oracle::combined_area(contours(input.polygon()), contours(input.window()),
                               [](bool in_polygon, bool in_window) { return in_polygon && in_window; });
}

std::array<mpq_class, 2> place(const intaglio::linear::SubPoint& v) { return {v.x, v.y}; }
std::array<mpq_class, 2> place(const intaglio::clip::BooleanVertex& v) {
  mpq_class x(v.x, v.denominator);
  mpq_class y(v.y, v.denominator);
  x.canonicalize();
  y.canonicalize();
  return {x, y};
}

template <class R>
mpq_class area_of(const lab::ClippedContours<R>& left) {
  oracle::RationalContours contours;
  std::size_t begin = 0;
  for (const int length : left.lengths) {
    contours.emplace_back();
    for (const auto& vertex : left.vertices.subspan(begin, static_cast<std::size_t>(length))) {
      const auto [x, y] = place(vertex);
      contours.back().push_back({x, y});
    }
    begin += static_cast<std::size_t>(length);
  }
  const mpq_class area = oracle::signed_area(contours);
  return area < 0 ? mpq_class(-area) : area;
}

/// True if a vertex of one contour lies on a side of the other.
bool lies_on(std::span<const intaglio::linear::SubPoint> vertices,
             std::span<const intaglio::linear::SubPoint> sides) {
  for (const auto p : vertices) {
    for (std::size_t i = 0; i < sides.size(); ++i) {
      const auto a = sides[i];
      const auto b = sides[(i + 1) % sides.size()];
      const std::int64_t across =
          std::int64_t{b.x - a.x} * (p.y - a.y) - std::int64_t{b.y - a.y} * (p.x - a.x);
      const std::int64_t along =
          std::int64_t{p.x - a.x} * (p.x - b.x) + std::int64_t{p.y - a.y} * (p.y - b.y);
      if (across == 0 && along <= 0) return true;
    }
  }
  return false;
}

bool touch(const lab::WindowAndPolygon& input) {
  return lies_on(input.polygon(), input.window()) || lies_on(input.window(), input.polygon());
}

struct PolygonClipErrors {
  using Family = lab::PolygonClip;
  using Case = std::array<std::int64_t, 1>;  // the number that window and polygon follow from

  template <class Visit>
  static std::string cases(int load, host::lab::Effort effort, Visit&& visit) {
    const std::int64_t count = effort.random(load == 0 ? 20'000 : 1'000);
    for (std::int64_t seed = 1; seed <= count; ++seed) visit(Case{seed});
    return "polygons of the numbers 1 to " + std::to_string(count) +
           ", those that touch the window left to the rungs that take them";
  }
  template <class R>
  static long double error(int load, const Case& c) {
    const Family::Input input(Family::vertices_of(load), static_cast<std::uint32_t>(c[0]));
    const auto left = Family::clipped<R>(input);
    // Greiner and Hormann's walk may refuse operands that touch, and no others.
    if (!left.ok) return std::is_same_v<R, intaglio::clip::GreinerHormann> && touch(input) ? 0 : 1e6L;
    const mpq_class off = area_of(left) - exact_area(input);
    return std::fabs(static_cast<long double>(off.get_d())) / 65536;
  }
};

}  // namespace

host::lab::FamilyReport host::lab::family_report() { return report<PolygonClipErrors>(); }
