// SPDX-License-Identifier: MIT
//
// Coverage of polygons: within its error bound, each pixel once, the same under any clip.
#include <intaglio/raster/coverage.hpp>
#include <tests/fuzz/polygon_input.hpp>
#include <tests/oracle/coverage.hpp>

#include <cstdlib>

namespace fuzz {
namespace {

using namespace intaglio::raster;

/// Remembers levels; reports spans that break the contract.
class Levels {
 public:
  explicit Levels(const Rect& clip)
      : clip_(clip), levels_(static_cast<std::size_t>(clip.width * clip.height)) {}
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

template <class F>
void on_surface(const Scene& scene, const Polygon& polygon, const Levels& whole,
                std::vector<CoverageCell>& cells, unsigned first, int steps) {
  const Rect& window = scene.window;
  std::vector<std::uint8_t> memory(static_cast<std::size_t>(F::row_bytes(window.width) * window.height));
  const auto surface = intaglio::image::Surface<F>::over_band(memory, window);
  require(surface.ok(), "a surface over a window is refused");
  const auto ramp = RampCoverage<F>::over(surface.value(), first, steps, scene.clip);
  if (!ramp.ok()) return;
  if (!fill_coverage(ramp.value(), polygon.rule, polygon.vertices, polygon.lengths, cells).ok()) return;
  for_pixels(window, [&](int x, int y) {
    const int level = scene.visible.contains({x, y}) ? whole.at(x, y) : 0;
    // The step nearest to level / 255 of the way; 255 is odd, so there are no ties.
    const unsigned step = static_cast<unsigned>((2 * level * (steps - 1) + 255) / 510);
    require(surface.value().get(x, y) == (level == 0 ? 0 : first + step), "not the step of the level");
  });
}

}  // namespace

void run(Input in) {
  const Scene scene(in, 32, 24);
  const Polygon polygon(in, scene, 16);
  const auto rule = polygon.rule;
  const auto& vertices = polygon.vertices;
  const auto& lengths = polygon.lengths;
  Levels whole(scene.window);
  auto cells = exact_workspace<CoverageCell>(
      [&](std::span<CoverageCell> space) { return fill_coverage(whole, rule, vertices, lengths, space); });
  if (cells.empty()) {
    const Status status = fill_coverage(whole, rule, vertices, lengths, cells);
    require(
        status.ok() == coverage_workspace(vertices, lengths, scene.window).ok() || rule > FillRule::non_zero,
        "fill_coverage and coverage_workspace disagree");
    require(whole.none(), "coverage without a cell");
    return;
  }
  require(whole.none(), "a call that fails hands coverage over");
  require(fill_coverage(whole, rule, vertices, lengths, cells).ok(), "the workspace needed isn't enough");
  Levels part(scene.visible);
  require(fill_coverage(part, rule, vertices, lengths, cells).ok(), "fails under a smaller clip");
  for_pixels(scene.visible,
             [&](int x, int y) { require(part.at(x, y) == whole.at(x, y), "another level under a clip"); });
  const auto first = static_cast<unsigned>(in.byte());
  const int steps = in.choice(256) + 1;
  on_surface<intaglio::image::Indexed8>(scene, polygon, whole, cells, first, steps);
  on_surface<intaglio::image::Indexed4>(scene, polygon, whole, cells, first & 15U, 1 + steps % 16);
  // Some pixels against the exact area: at most 1/2 + edges / 2^15 levels off.
  oracle::Contours contours = polygon.contours();
  std::erase_if(contours, [](const auto& contour) { return contour.size() < 3; });
  for (int i = 0; i < 6; ++i) {
    const int x = scene.window.x + in.choice(scene.window.width);
    const int y = scene.window.y + in.choice(scene.window.height);
    const mpq_class exact = 255 * oracle::coverage(contours, polygon.even_odd(), x, y);
    const mpq_class bound = mpq_class(1, 2) + mpq_class(static_cast<unsigned>(vertices.size()), 1U << 15U);
    require(abs(exact - whole.at(x, y)) <= bound, "a level further from the exact area than the bound");
  }
}

}  // namespace fuzz
