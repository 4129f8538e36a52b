// SPDX-License-Identifier: MIT
//
// Levels that pixels of a triangle are off, against its area in them in rational numbers.
#include <host/lab/errors/report.hpp>
#include <tests/oracle/coverage.hpp>

#include <cstdlib>
#include <firmware/lab/families/antialiasing.hpp>

namespace {

/// Keeps levels.
class LevelMap {
 public:
  explicit LevelMap(const intaglio::linear::Rect& box)
      : box_(box), levels_(static_cast<std::size_t>(box.width) * static_cast<std::size_t>(box.height)) {}
  [[nodiscard]] const intaglio::linear::Rect& clip() const { return box_; }
  void span(int y, int x_begin, int x_end, int coverage) {
    for (int x = x_begin; x < x_end; ++x) levels_[place(x, y)] = coverage;
  }
  [[nodiscard]] int level(int x, int y) const { return levels_[place(x, y)]; }

 private:
  [[nodiscard]] std::size_t place(int x, int y) const {
    return static_cast<std::size_t>((y - box_.y) * box_.width + x - box_.x);
  }
  intaglio::linear::Rect box_;
  std::vector<int> levels_;
};

struct AntialiasingErrors {
  using Family = lab::Antialiasing;
  using Case = std::array<std::int64_t, 1>;  // the number that the triangle follows from

  template <class Visit>
  static std::string cases(int load, host::lab::Effort effort, Visit&& visit) {
    const std::int64_t count = effort.full() ? (load == 0 ? 2'000 : 5'000) : 100;
    for (std::int64_t seed = 1; seed <= count; ++seed) visit(Case{seed});
    return "triangles of the numbers 1 to " + std::to_string(count);
  }

  template <class R>
  static long double error(int load, const Case& c) {
    const auto in = Family::triangle(load, static_cast<std::uint32_t>(c[0]));
    LevelMap map(in.box);
    if (!Family::draw<R>(map, in.triangle)) return 255;
    const oracle::Contours contours{{in.triangle.begin(), in.triangle.end()}};
    long double worst = 0;
    for (int y = in.box.y; y < in.box.bottom(); ++y) {
      for (int x = in.box.x; x < in.box.right(); ++x) {
        const int edges = edges_through(in.triangle, x, y);
        if (edges == 0) {
          // All in or all out, as its middle is.
          const int level =
              oracle::in_triangle(in.triangle[0], in.triangle[1], in.triangle[2], x, y) ? 255 : 0;
          worst = std::max<long double>(worst, std::abs(level - map.level(x, y)));
          continue;
        }
        if (load == 0 && edges > 1) continue;
        const mpq_class area = oracle::coverage(contours, false, x, y);
        const mpq_class off = abs(255 * area - map.level(x, y));
        worst = std::max<long double>(worst, off.get_d());
      }
    }
    return worst;
  }

 private:
  /// How many edges' lines go through the inside of a pixel.
  static int edges_through(const lab::raster::TriangleCorners& t, int x, int y) {
    int count = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto a = t[i];
      const auto b = t[(i + 1) % 3];
      const std::int64_t dx = b.x - a.x;
      const std::int64_t dy = b.y - a.y;
      const std::int64_t middle = dx * (256 * y - a.y) - dy * (256 * x - a.x);
      if (std::abs(middle) < 128 * (std::abs(dx) + std::abs(dy))) ++count;
    }
    return count;
  }
};

}  // namespace

host::lab::FamilyReport host::lab::family_report() { return report<AntialiasingErrors>(); }
