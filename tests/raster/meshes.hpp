// SPDX-License-Identifier: MIT
//
// Meshes that cover a window: fans, strips of triangles, and cells of which three meet at each vertex, as in
// a Voronoi diagram. Drawn cell by cell, each pixel of the window must be drawn once.
#pragma once

#include <intaglio/raster/polygon.hpp>
#include <intaglio/raster/polygon_basic.hpp>
#include <intaglio/raster/polygon_critical.hpp>
#include <intaglio/raster/triangle.hpp>
#include <intaglio/raster/triangle_box.hpp>
#include <tests/oracle/polygon.hpp>
#include <tests/oracle/random.hpp>
#include <tests/oracle/recording_sink.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace tests {

inline constexpr intaglio::linear::Rect mesh_window{0, 0, 64, 48};

/// What became of the pixels of many meshes.
struct Cover {
  std::int64_t meshes = 0;
  std::int64_t cells = 0;
  std::int64_t pixels = 0;
  std::int64_t twice = 0;
  std::int64_t missing = 0;
  std::int64_t refused = 0;
};

/// Draws one cell by one of three methods.
template <class S>
intaglio::Status draw_cell(S& sink, const oracle::Contour& cell, int method) {
  using namespace intaglio::raster;
  if (cell.size() == 3)
    return method % 3 == 0   ? fill_triangle(sink, cell[0], cell[1], cell[2])
           : method % 3 == 1 ? fill_triangle_box(sink, cell[0], cell[1], cell[2])
                             : fill_triangle_blocks(sink, cell[0], cell[1], cell[2]);
  const std::array lengths{static_cast<int>(cell.size())};
  constexpr std::size_t most = 6;
  if (method % 3 == 0) {
    std::array<PolygonEdge, most> workspace;
    return fill_polygon(sink, FillRule::even_odd, cell, lengths, workspace);
  }
  if (method % 3 == 1) {
    std::array<PolygonCrossing, most> workspace;
    return fill_polygon_basic(sink, FillRule::non_zero, cell, lengths, workspace);
  }
  std::array<PolygonChain, most> workspace;
  return fill_polygon_critical(sink, FillRule::even_odd, cell, lengths, workspace);
}

inline void add_mesh(Cover& cover, const oracle::Contours& cells, int method) {
  oracle::RecordingSink sink(mesh_window);
  for (const auto& cell : cells) cover.refused += draw_cell(sink, cell, method++).ok() ? 0 : 1;
  ++cover.meshes;
  cover.cells += static_cast<std::int64_t>(cells.size());
  for (const int writes : sink.all_writes()) {
    ++cover.pixels;
    cover.twice += writes > 1 ? 1 : 0;
    cover.missing += writes == 0 ? 1 : 0;
  }
}

/// A hub in the window and a rim around it, up to the domain's edge; `step` makes vertices coincide with the
/// centres of pixels.
inline oracle::Contours random_fan(oracle::Random& random, int step) {
  using intaglio::linear::SubPoint;
  const int far = 1 << random.between(15, 28);
  const SubPoint hub{random.between(0, 64 * 256) / step * step, random.between(0, 48 * 256) / step * step};
  oracle::Contour rim;
  for (int side = 0; side < 4; ++side) {
    const SubPoint corners[] = {{-far, -far}, {far, -far}, {far, far}, {-far, far}};
    const SubPoint from = corners[side];
    const SubPoint to = corners[(side + 1) % 4];
    rim.push_back(from);
    const int part = random.between(1, 1023);
    rim.push_back({static_cast<int>(from.x + (std::int64_t{to.x} - from.x) * part / 1024),
                   static_cast<int>(from.y + (std::int64_t{to.y} - from.y) * part / 1024)});
  }
  oracle::Contours cells;
  for (std::size_t i = 0; i < rim.size(); ++i) cells.push_back({hub, rim[i], rim[(i + 1) % rim.size()]});
  return cells;
}

/// A grid of vertices that are moved at random, less than half the way to the next, around the window.
class LooseGrid {
 public:
  LooseGrid(oracle::Random& random, int step) : spacing_(random.between(3, 14) * 256) {
    columns_ = 66 * 256 / spacing_ + 5;
    rows_ = 50 * 256 / spacing_ + 5;
    for (int row = 0; row < rows_; ++row)
      for (int column = 0; column < columns_; ++column) {
        const int most = spacing_ * 2 / 5;
        const int x = (column - 2) * spacing_ + random.between(-most, most);
        const int y = (row - 2) * spacing_ + random.between(-most, most);
        places_.push_back({x / step * step, y / step * step});
      }
  }
  [[nodiscard]] int columns() const { return columns_; }
  [[nodiscard]] int rows() const { return rows_; }
  [[nodiscard]] intaglio::linear::SubPoint at(int column, int row) const {
    return places_[static_cast<std::size_t>(row * columns_ + column)];
  }

 private:
  int spacing_;
  int columns_;
  int rows_;
  std::vector<intaglio::linear::SubPoint> places_;
};

/// Strips of triangles, one a row of the grid. The quadrilaterals are cut along either diagonal; where one
/// has a dent, that would fold a triangle over, it stays whole.
inline oracle::Contours random_strips(oracle::Random& random, int step) {
  const LooseGrid grid(random, step);
  oracle::Contours cells;
  const auto turn = [](auto a, auto b, auto c) {
    return (std::int64_t{b.x} - a.x) * (c.y - a.y) - (std::int64_t{b.y} - a.y) * (c.x - a.x) > 0;
  };
  for (int row = 0; row + 1 < grid.rows(); ++row)
    for (int column = 0; column + 1 < grid.columns(); ++column) {
      const auto a = grid.at(column, row);
      const auto b = grid.at(column + 1, row);
      const auto c = grid.at(column + 1, row + 1);
      const auto d = grid.at(column, row + 1);
      if (turn(a, b, c) && turn(c, d, a) && random.between(0, 1) == 0) {
        cells.push_back({a, b, c});
        cells.push_back({c, d, a});
      } else if (turn(b, c, d) && turn(d, a, b)) {
        cells.push_back({b, c, d});
        cells.push_back({d, a, b});
      } else {
        cells.push_back({a, b, c, d});
      }
    }
  return cells;
}

/// Cells of six vertices laid as bricks: each vertex belongs to three.
inline oracle::Contours random_bricks(oracle::Random& random, int step) {
  const LooseGrid grid(random, step);
  oracle::Contours cells;
  for (int row = 0; row + 1 < grid.rows(); ++row)
    for (int column = row % 2; column + 2 < grid.columns(); column += 2)
      cells.push_back({grid.at(column, row), grid.at(column + 1, row), grid.at(column + 2, row),
                       grid.at(column + 2, row + 1), grid.at(column + 1, row + 1), grid.at(column, row + 1)});
  return cells;
}

/// As many of each kind; what should be missing or drawn twice is nothing.
inline Cover cover_by_meshes(int of_each) {
  oracle::Random random(4300);
  Cover cover;
  for (int i = 0; i < of_each; ++i) {
    const int step = i % 3 == 0 ? 256 : i % 3 == 1 ? 128 : 1;
    add_mesh(cover, random_fan(random, step), i);
    add_mesh(cover, random_strips(random, step), i);
    add_mesh(cover, random_bricks(random, step), i);
  }
  return cover;
}

}  // namespace tests
