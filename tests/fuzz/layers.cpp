// SPDX-License-Identifier: MIT
//
// Layers, front first: by their exact visible areas and by masks. Of each pixel the layers come in order and
// share no more than all of it; the same under any clip; some pixels against the exact area.
#include <intaglio/raster/enlargement.hpp>
#include <intaglio/raster/mask_buffer.hpp>
#include <intaglio/raster/polygon.hpp>
#include <intaglio/raster/visible_area.hpp>
#include <tests/fuzz/polygon_input.hpp>
#include <tests/fuzz/workspace.hpp>
#include <tests/oracle/visible_area.hpp>

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace fuzz {
namespace {

using namespace intaglio::raster;
constexpr int most_layers = 3;

/// Remembers the levels of all layers; reports what breaks the contract.
class Layers {
 public:
  explicit Layers(const Rect& clip)
      : clip_(clip), pixels_(static_cast<std::size_t>(clip.width) * static_cast<std::size_t>(clip.height)) {}
  [[nodiscard]] const Rect& clip() const { return clip_; }
  void span(int layer, int y, int x_begin, int x_end, int level) {
    require(layer >= 0 && layer < most_layers, "no such layer");
    require(
        x_begin < x_end && x_begin >= clip_.x && x_end <= clip_.right() && y >= clip_.y && y < clip_.bottom(),
        "a span outside the clip");
    require(level >= 1, "a level below 1");
    for (int x = x_begin; x < x_end; ++x) {
      Pixel& pixel = pixels_[index(x, y)];
      require(layer >= pixel.next, "a layer twice or too late");
      pixel.next = layer + 1;
      pixel.levels[static_cast<std::size_t>(layer)] = level;
      pixel.sum += level;
      require(pixel.sum <= full_coverage, "a pixel more than full");
    }
  }
  [[nodiscard]] const std::array<int, most_layers>& at(int x, int y) const {
    return pixels_[index(x, y)].levels;
  }
  [[nodiscard]] bool none() const {
    return std::all_of(pixels_.begin(), pixels_.end(), [](const Pixel& pixel) { return pixel.sum == 0; });
  }

 private:
  struct Pixel {
    std::array<int, most_layers> levels{};
    int sum = 0;
    int next = 0;
  };
  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>((y - clip_.y) * clip_.width + (x - clip_.x));
  }
  Rect clip_;
  std::vector<Pixel> pixels_;
};

void require_same(const Scene& scene, const Layers& whole, const Layers& part) {
  for_pixels(scene.visible,
             [&](int x, int y) { require(part.at(x, y) == whole.at(x, y), "another level under a clip"); });
}

void visible(const Scene& scene, Input& in, const std::vector<Polygon>& polygons) {
  std::vector<DepthPolygon> set;
  bool triangles = true;
  std::vector<std::pair<oracle::Contours, bool>> exact;
  for (const Polygon& polygon : polygons) {
    set.push_back({polygon.rule, polygon.vertices, polygon.lengths});
    triangles = triangles && polygon.lengths.size() == 1 && polygon.vertices.size() == 3;
  }
  Layers whole(scene.window);
  auto entries = exact_workspace<VisibleEntry>(
      [&](std::span<VisibleEntry> space) { return cover_front_to_back(whole, set, space); });
  require(whole.none(), "a call that fails hands coverage over");
  const Status status = cover_front_to_back(whole, set, entries);
  require(status.ok() || whole.none(), "a call that fails hands coverage over");
  Layers part(scene.visible);
  require(cover_front_to_back(part, set, entries) == status, "another status under a clip");
  require_same(scene, whole, part);
  if (!status.ok() || !triangles) return;
  exact.reserve(polygons.size());
  for (const Polygon& polygon : polygons) exact.emplace_back(oracle::Contours{polygon.vertices}, true);
  for (int i = 0; i < 4; ++i) {
    const int x = scene.window.x + in.choice(scene.window.width);
    const int y = scene.window.y + in.choice(scene.window.height);
    const auto areas = oracle::visible_areas(exact, x, y);
    for (std::size_t layer = 0; layer < areas.size(); ++layer)
      // 9 edges: (9 + 81) / 2^15 beyond the roundings.
      require(abs(255 * areas[layer] - whole.at(x, y)[layer]) <= 1 + mpq_class(90, 1U << 15U),
              "a level further from the exact area than the bound");
  }
}

void masks(const Scene& scene, MaskGrid grid, const std::vector<Polygon>& polygons) {
  const Enlargement by(MaskSink::across, static_cast<int>(grid));
  const auto cover = [&](Layers& sink) {
    std::vector<MaskCell> cells(static_cast<std::size_t>(scene.window.width));
    return cover_by_masks(sink, grid, static_cast<int>(polygons.size()), cells,
                          [&](int layer, MaskSink& parts) {
                            const Polygon& polygon = polygons[static_cast<std::size_t>(layer)];
                            std::vector<SubPoint> vertices = polygon.vertices;
                            for (SubPoint& vertex : vertices) vertex = by.place(vertex);
                            std::vector<PolygonEdge> edges(vertices.size());
                            return fill_polygon(parts, polygon.rule, vertices, polygon.lengths, edges);
                          });
  };
  Layers whole(scene.window);
  if (!cover(whole).ok()) return;  // a layer behind the first may fail after that was handed over
  Layers part(scene.visible);
  require(cover(part).ok(), "fails under a smaller clip");
  require_same(scene, whole, part);
}

}  // namespace

void run(Input in) {
  const int kind = in.byte();
  const Scene scene(in, 16, 12);
  std::vector<Polygon> polygons;
  for (int n = 1 + kind / 4 % most_layers; n > 0; --n) polygons.emplace_back(in, scene, 6);
  if (kind % 2 == 0) return visible(scene, in, polygons);
  masks(scene, kind % 4 == 1 ? MaskGrid::four_by_four : MaskGrid::four_by_eight, polygons);
}

}  // namespace fuzz
