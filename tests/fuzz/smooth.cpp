// SPDX-License-Identifier: MIT
//
// Coverage: of polygons and lines by area, by an error term, by samples; and the sinks that show it. Levels
// are within their error bounds, each pixel once, the same under any clip.
#include <intaglio/raster/adaptive.hpp>
#include <intaglio/raster/blend_coverage.hpp>
#include <intaglio/raster/coverage.hpp>
#include <intaglio/raster/dithered_coverage.hpp>
#include <intaglio/raster/inside.hpp>
#include <intaglio/raster/pitteway.hpp>
#include <intaglio/raster/polygon.hpp>
#include <intaglio/raster/smooth_line.hpp>
#include <intaglio/raster/stochastic.hpp>
#include <intaglio/raster/supersample.hpp>
#include <tests/fuzz/polygon_input.hpp>
#include <tests/oracle/coverage.hpp>

#include <array>
#include <cstdlib>

namespace fuzz {
namespace {

using namespace intaglio::raster;
using intaglio::image::BlendTable;

/// Remembers levels; reports spans that break the contract.
class Levels {
 public:
  explicit Levels(const Rect& clip)
      : clip_(clip), levels_(static_cast<std::size_t>(clip.width) * static_cast<std::size_t>(clip.height)) {}
  [[nodiscard]] const Rect& clip() const { return clip_; }
  void span(int y, int x_begin, int x_end, int level) {
    require(
        x_begin < x_end && x_begin >= clip_.x && x_end <= clip_.right() && y >= clip_.y && y < clip_.bottom(),
        "a span outside the clip");
    require(level >= 1 && level <= full_coverage, "a level that isn't 1 to 255");
    for (int x = x_begin; x < x_end; ++x) {
      require(at(x, y) == 0, "a pixel handed over twice");
      levels_[index(x, y)] = level;
    }
  }
  [[nodiscard]] int at(int x, int y) const { return levels_[index(x, y)]; }
  [[nodiscard]] bool none() const {
    return std::all_of(levels_.begin(), levels_.end(), [](int level) { return level == 0; });
  }

 private:
  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>((y - clip_.y) * clip_.width + (x - clip_.x));
  }
  Rect clip_;
  std::vector<int> levels_;
};

struct Covered {
  Status status;
  Levels levels;
};

template <class Draw>
Covered covered(const Rect& window, Draw draw) {
  Covered result{{}, Levels(window)};
  result.status = draw(result.levels);
  require(result.status.ok() || result.levels.none(), "a call that fails hands coverage over");
  return result;
}

/// Draws through `sink` on a surface of F, then asks of each pixel what it should be: `expected(before,
/// level)`.
template <class F, class MakeSink, class Draw, class Expected>
void on_surface(const Scene& scene, const Covered& whole, MakeSink make_sink, Draw draw, Expected expected) {
  const Rect& window = scene.window;
  std::vector<std::uint8_t> memory(static_cast<std::size_t>(F::row_bytes(window.width) * window.height));
  for (std::size_t i = 0; i < memory.size(); ++i) memory[i] = static_cast<std::uint8_t>(i * 37U & 255U);
  const std::vector<std::uint8_t> before = memory;
  const auto surface = intaglio::image::Surface<F>::over_band(memory, window).value();
  const auto old = intaglio::image::Picture<F>::over_band(before, window).value();
  auto sink = make_sink(surface);
  require(draw(sink) == whole.status, "another status on a surface");
  for_pixels(window, [&](int x, int y) {
    const int level = scene.visible.contains({x, y}) ? whole.levels.at(x, y) : 0;
    require(surface.get(x, y) == (level == 0 ? old.get(x, y) : expected(x, y, old.get(x, y), level)),
            "not what the level says");
  });
}

/// The step nearest to level / 255 of the way to `last`; 255 is odd, so there are no ties.
unsigned step_of(int level, int last) { return static_cast<unsigned>((2 * level * last + 255) / 510); }

template <class Draw>
void on_surfaces(Input& in, const Scene& scene, const Covered& whole, Draw draw) {
  using namespace intaglio::image;
  const int kind = in.choice(4);
  const auto first = static_cast<unsigned>(in.byte());
  if (kind == 0) {
    const int steps = 256 - static_cast<int>(first);
    on_surface<Indexed8>(
        scene, whole,
        [&](const auto& s) { return RampCoverage<Indexed8>::over(s, first, steps, scene.clip).value(); },
        draw, [&](int, int, unsigned, int level) { return first + step_of(level, steps - 1); });
  } else if (kind == 1) {
    const unsigned from = first & 15U;
    const int steps = 16 - static_cast<int>(from);
    on_surface<Indexed4>(
        scene, whole,
        [&](const auto& s) { return RampCoverage<Indexed4>::over(s, from, steps, scene.clip).value(); }, draw,
        [&](int, int, unsigned, int level) { return from + step_of(level, steps - 1); });
  } else if (kind == 2) {
    const int steps = 2 + static_cast<int>(first >> 4U);
    const int index = static_cast<int>(first & 3U);
    std::array<std::uint8_t, 12> palette{};
    for (std::uint8_t& byte : palette) byte = static_cast<std::uint8_t>(in.byte());
    std::vector<std::uint8_t> table(BlendTable::bytes(4, steps));
    require(make_blend_table(table, palette, index, steps).ok(), "make_blend_table refuses");
    const auto blend = BlendTable::over(table, 4, index, steps).value();
    on_surface<Indexed2>(
        scene, whole,
        [&](const auto& s) { return BlendCoverage<Indexed2>::over(s, blend, scene.clip).value(); }, draw,
        [&](int, int, unsigned old, int level) {
          const unsigned step = step_of(level, steps - 1);
          if (step == 0) return old;
          if (step == static_cast<unsigned>(steps - 1)) return static_cast<unsigned>(index);
          return unsigned{table[(step - 1) * 4 + old]};
        });
  } else {
    const auto pattern = first % 2 == 0 ? DitherPattern::normal : DitherPattern::reversed;
    const unsigned index = first >> 1U & 1U;
    using Ink = Solid<Indexed1>;
    DitheredCoverage<Ink> known(Ink({}, 0), pattern);
    on_surface<Indexed1>(
        scene, whole,
        [&](const auto& s) { return DitheredCoverage<Ink>(Ink(s, index, scene.clip), pattern); }, draw,
        [&](int x, int y, unsigned old, int level) { return known.draws(x, y, level) ? index : old; });
  }
}

/// Checks one call, `draw(sink)` for any coverage sink, and returns what it handed over.
template <class Draw>
Covered check_coverage(Input& in, const Scene& scene, Draw draw) {
  Covered whole = covered(scene.window, draw);
  const Covered part = covered(scene.visible, draw);
  require(part.status == whole.status, "another status under a clip");
  for_pixels(scene.visible, [&](int x, int y) {
    require(part.levels.at(x, y) == whole.levels.at(x, y), "another level under a clip");
  });
  if (whole.status.ok()) on_surfaces(in, scene, whole, draw);
  return whole;
}

/// Calls `visit(x, y)` for a few pixels of the window.
template <class Visit>
void for_some(Input& in, const Scene& scene, Visit visit) {
  for (int i = 0; i < 6; ++i) {
    const int x = scene.window.x + in.choice(scene.window.width);
    visit(x, scene.window.y + in.choice(scene.window.height));
  }
}

void area(Input& in, const Scene& scene) {
  const Polygon polygon(in, scene, 16);
  Levels probe(scene.window);
  auto cells = exact_workspace<CoverageCell>([&](std::span<CoverageCell> space) {
    return fill_coverage(probe, polygon.rule, polygon.vertices, polygon.lengths, space);
  });
  const Covered whole = check_coverage(in, scene, [&](auto& sink) {
    return fill_coverage(sink, polygon.rule, polygon.vertices, polygon.lengths, cells);
  });
  if (!whole.status.ok()) return;
  const auto needed = coverage_workspace(polygon.vertices, polygon.lengths, scene.window);
  require(needed.ok() && needed.value() == cells.size(), "coverage_workspace isn't what fill_coverage needs");
  // At most 1/2 + 2^-22 + edges / 2^20 levels from the exact area.
  oracle::Contours contours = polygon.contours();
  std::erase_if(contours, [](const auto& contour) { return contour.size() < 3; });
  for_some(in, scene, [&](int x, int y) {
    const mpq_class exact = 255 * oracle::coverage(contours, polygon.even_odd(), x, y);
    const mpq_class bound =
        mpq_class(1, 2) + mpq_class(4U * static_cast<unsigned>(polygon.vertices.size()) + 1U, 1U << 22U);
    require(abs(exact - whole.levels.at(x, y)) <= bound,
            "a level further from the exact area than the bound");
  });
}

void line(Input& in, const Scene& scene) {
  const SubPoint a = scene.sub_point(in);
  const SubPoint b = scene.sub_point(in);
  const int width = in.sub_coordinate(0, 32);
  const auto cap = static_cast<Cap>(in.choice(4));
  std::vector<CoverageCell> cells(coverage_cells(smooth_line_vertices, scene.window.width));
  const Covered whole =
      check_coverage(in, scene, [&](auto& sink) { return draw_smooth_line(sink, a, b, width, cap, cells); });
  const Covered back =
      covered(scene.window, [&](auto& sink) { return draw_smooth_line(sink, b, a, width, cap, cells); });
  for_pixels(scene.window, [&](int x, int y) {
    require(whole.levels.at(x, y) == back.levels.at(x, y), "draw_smooth_line: from B to A isn't from A to B");
  });
}

void pitteway(Input& in, const Scene& scene) {
  std::vector<SubPoint> vertices(static_cast<std::size_t>(in.choice(8)));
  for (SubPoint& p : vertices) p = scene.sub_point(in);
  check_coverage(in, scene, [&](auto& sink) { return fill_convex_pitteway(sink, vertices); });
}

/// The weight of each of the samples along one axis of a window.
int weight(const Supersampling& grid, int i) {
  return grid.filter == SampleFilter::box ? 1 : std::min(i + 1, grid.width - i);
}

/// The level of a pixel by looking at each sample.
template <class Inside>
int sampled(const Supersampling& grid, int x, int y, Inside inside) {
  const int margin = (grid.width - grid.scale) / 2;
  int sum = 0;
  int total = 0;
  for (int v = 0; v < grid.width; ++v)
    for (int u = 0; u < grid.width; ++u) {
      const int w = weight(grid, u) * weight(grid, v);
      total += w;
      if (inside(x * grid.scale - margin + u, y * grid.scale - margin + v)) sum += w;
    }
  return (2 * 255 * sum + total) / (2 * total);
}

void samples(Input& in, const Scene& scene) {
  const Polygon polygon(in, scene, 8);
  const int kind = in.byte();
  Supersampling grid;
  if (kind < 0xC0) {
    grid = supersampling_rungs[static_cast<std::size_t>(kind) % supersampling_rungs.size()].grid;
  } else {
    grid = {in.choice(10), in.choice(10), static_cast<SampleFilter>(in.choice(3))};
  }
  const Enlargement enlargement(grid.scale);
  std::vector<SubPoint> vertices = polygon.vertices;
  for (SubPoint& p : vertices) p = enlargement.place(p);
  std::vector<PolygonEdge> edges(vertices.size());
  // One row at a time, or more.
  const int rows = 1 + in.choice(4);
  std::vector<SampleCell> cells(static_cast<std::size_t>(rows) *
                                static_cast<std::size_t>(scene.window.width));
  const Covered whole = check_coverage(in, scene, [&](auto& sink) {
    return supersample(sink, grid, cells, [&](SampleSink& fine) {
      return fill_polygon(fine, polygon.rule, vertices, polygon.lengths, edges);
    });
  });
  if (!whole.status.ok()) return;
  // At the edge of the domain what doesn't fit enlarged is left out.
  constexpr int limit = intaglio::linear::coordinate_limit / 8 - 64;
  if (std::abs(scene.window.x) > limit || std::abs(scene.window.y) > limit) return;
  Polygon enlarged = polygon;
  enlarged.vertices = vertices;
  const oracle::Contours contours = enlarged.contours();
  for_some(in, scene, [&](int x, int y) {
    const int expected = sampled(
        grid, x, y, [&](int u, int v) { return oracle::in_polygon(contours, polygon.even_odd(), u, v); });
    require(whole.levels.at(x, y) == expected, "supersample: not the weight of the samples");
  });
}

void by_places(Input& in, const Scene& scene) {
  const Polygon polygon(in, scene, 8);
  const int scale = in.choice(8) + 2;
  const bool adaptive = in.choice(2) == 0;
  const auto seed = static_cast<std::uint32_t>(in.any());
  const Enlargement enlargement(scale);
  Rect box = scene.window;
  std::vector<SubPoint> vertices = polygon.vertices;
  for (SubPoint& p : vertices) p = enlargement.place(p);
  const auto inside = [&](SubPoint p) {
    const auto answer = inside_polygon(polygon.rule, vertices, polygon.lengths, p);
    require(answer.status().argument() != intaglio::Argument::point, "asks for a place outside the domain");
    return answer.ok() && answer.value();
  };
  if (in.choice(2) == 0) {
    const Point corner = scene.point(in);
    box = {corner.x, corner.y, in.length(), in.length()};
  }
  const Covered whole = check_coverage(in, scene, [&](auto& sink) {
    return adaptive ? cover_adaptively(sink, box, scale, inside)
                    : cover_stochastically(sink, box, scale, seed, inside);
  });
  if (!whole.status.ok() || !adaptive) return;
  for_some(in, scene, [&](int x, int y) {
    const int level = whole.levels.at(x, y);
    if (level == 0 || level == full_coverage) return;
    const Supersampling grid{scale, scale, SampleFilter::box};
    require(level == sampled(grid, x, y,
                             [&](int u, int v) {
                               return inside({u * 256, v * 256});
                             }),
            "cover_adaptively: not the samples of the box");
  });
}

}  // namespace

void run(Input in) {
  const int what = in.choice(8);
  const Scene scene(in, 32, 24);
  if (what == 0) return line(in, scene);
  if (what == 1) return pitteway(in, scene);
  if (what < 4) return samples(in, scene);
  if (what < 6) return by_places(in, scene);
  area(in, scene);
}

}  // namespace fuzz
