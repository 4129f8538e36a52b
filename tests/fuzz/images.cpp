// SPDX-License-Identifier: MIT
//
// Pictures copied, stretched and turned: only what the rule says changes, whatever overlaps.
#include <intaglio/image/blit.hpp>
#include <intaglio/image/rotozoom.hpp>
#include <intaglio/image/scale.hpp>
#include <intaglio/image/three_shear.hpp>
#include <tests/fuzz/scene.hpp>
#include <tests/image/placements.hpp>
#include <tests/oracle/scale.hpp>

#include <map>
#include <optional>
#include <utility>

namespace fuzz {
namespace {

using namespace intaglio;
using image::Picture;
using image::Surface;

/// A picture as it was, one index a pixel.
template <class F>
std::vector<unsigned> indices(const Picture<F>& picture) {
  std::vector<unsigned> result;
  for_pixels(picture.bounds(), [&](int x, int y) { result.push_back(picture.get(x, y)); });
  return result;
}

/// Source and target; the source may be part of the target's memory.
template <class F, class G>
struct Pair {
  std::vector<std::uint8_t> memory;
  std::vector<std::uint8_t> source_memory;
  Surface<F> target;
  Picture<G> source;

  Pair(Input& in, const Scene& scene) {
    const Rect& window = scene.window;
    const int stride = F::row_bytes(window.width) + in.choice(3);
    memory.resize(static_cast<std::size_t>(stride * window.height));
    unsigned seed = static_cast<unsigned>(in.byte());
    const auto fill = [&](std::vector<std::uint8_t>& bytes) {
      for (std::uint8_t& byte : bytes) {
        seed = (seed * 1103515245U + 12345U) & 0x7FFFFFFFU;
        byte = static_cast<std::uint8_t>(seed >> 16U & 255U);
      }
    };
    fill(memory);
    target = Surface<F>::over_band(memory, window, stride).value();
    const int width = 1 + in.choice(24);
    const int height = 1 + in.choice(16);
    if constexpr (std::is_same_v<F, G>) {
      const int x = in.choice(40);
      const int y = in.choice(24);
      if (in.choice(2) == 0) {
        source = target.sub({window.x + x, window.y + y, width, height});
        return;
      }
    }
    source_memory.resize(static_cast<std::size_t>(G::row_bytes(width) * height));
    fill(source_memory);
    source = Picture<G>::over(source_memory, {width, height}).value();
  }
};

/// Calls `copy(rule)`; `source_of(x, y)` is the source's pixel that the target's shows, if any.
template <class F, class G, class Rule, class Copy, class SourceOf>
void check_copy(const Scene& scene, Pair<F, G>& pair, const Rule& rule, Copy copy, SourceOf source_of) {
  const std::vector<std::uint8_t> bytes_before = pair.memory;
  const auto before = indices<F>(pair.target);
  const auto source = indices<G>(pair.source);
  const int columns = pair.source.size().width;
  const Status status = copy(rule);
  if (!status.ok()) {
    require(pair.memory == bytes_before, "a call that fails draws");
    return;
  }
  auto old = before.begin();
  Surface<F> restored = pair.target;
  for_pixels(scene.window, [&](int x, int y) {
    unsigned expected = *old;
    if (scene.visible.contains({x, y}))
      if (const std::optional<Point> from = source_of(x, y)) {
        const unsigned index = source[static_cast<std::size_t>(from->y * columns + from->x)];
        bool seen = rule.shows(index);
        if constexpr (requires { rule.mask; }) seen = seen && rule.mask.get(from->x, from->y) != 0;
        if (seen) expected = rule.map(index);
      }
    require(pair.target.get(x, y) == expected, "not the pixel of the source");
    restored.set(x, y, *old);
    ++old;
  });
  require(pair.memory == bytes_before, "memory beside the pixels changes");
}

template <class F, class G, class Rule>
void copies(Input& in, const Scene& scene, Pair<F, G>& pair, const Rule& rule) {
  const auto size = pair.source.size();
  switch (in.choice(4)) {
    case 0: {
      const Point at = scene.point(in);
      check_copy<F, G>(
          scene, pair, rule,
          [&](const Rule& r) { return image::blit(pair.target, at, pair.source, r, scene.clip); },
          [&](int x, int y) -> std::optional<Point> {
            if (x < at.x || y < at.y || x - at.x >= size.width || y - at.y >= size.height) return {};
            return Point{x - at.x, y - at.y};
          });
      return;
    }
    case 1: {
      const Point corner = scene.point(in);
      const int width = in.length();
      const int height = in.length();
      const Rect to{corner.x, corner.y, width, height};
      check_copy<F, G>(
          scene, pair, rule,
          [&](const Rule& r) { return image::blit_scaled(pair.target, to, pair.source, r, scene.clip); },
          [&](int x, int y) -> std::optional<Point> {
            if (size.width == 0 || x < to.x || y < to.y || x >= to.right() || y >= to.bottom()) return {};
            return Point{oracle::scaled_source(x - to.x, size.width, to.width),
                         oracle::scaled_source(y - to.y, size.height, to.height)};
          });
      return;
    }
    case 2: {
      image::ThreeShear placement;
      placement.position = scene.sub_point(in);
      placement.pivot = scene.sub_point(in);
      placement.angle = number::Angle::from_steps(in.byte() * 256 + in.choice(3));
      const oracle::ThreeShear map = tests::oracle_of(placement, size);
      std::map<std::pair<oracle::Wide, oracle::Wide>, Point> landed;
      for_pixels({0, 0, size.width, size.height}, [&](int x, int y) {
        const auto place = map.land(x, y);
        require(landed.try_emplace({place.x, place.y}, Point{x, y}).second, "two pixels land on one");
      });
      check_copy<F, G>(
          scene, pair, rule,
          [&](const Rule& r) {
            return image::blit_three_shear(pair.target, placement, pair.source, r, scene.clip);
          },
          [&](int x, int y) -> std::optional<Point> {
            const auto found = landed.find({x, y});
            if (found == landed.end()) return {};
            return found->second;
          });
      return;
    }
    default: {
      image::Rotozoom placement;
      placement.position = scene.sub_point(in);
      placement.pivot = scene.sub_point(in);
      placement.angle = number::Angle::from_steps(in.byte() * 256 + in.choice(3));
      const int scale = in.byte();
      placement.scale = number::Fixed<16>::from_raw(scale < 0x80   ? 1 << scale % 26
                                                    : scale < 0xF0 ? (scale - 0x70) * 1024
                                                                   : in.any());
      const oracle::Rotozoom map = tests::oracle_of(placement);
      check_copy<F, G>(
          scene, pair, rule,
          [&](const Rule& r) {
            return image::blit_rotozoom(pair.target, placement, pair.source, r, scene.clip);
          },
          [&](int x, int y) -> std::optional<Point> {
            const auto column = map.column(x, y);
            const auto row = map.row(x, y);
            if (column < 0 || row < 0 || column >= size.width || row >= size.height) return {};
            return Point{static_cast<int>(column), static_cast<int>(row)};
          });
    }
  }
}

template <class F, class G>
void rules(Input& in) {
  const Scene scene(in);
  Pair<F, G> pair(in, scene);
  const auto key = static_cast<unsigned>(in.byte()) % (G::max_index + 2);
  std::vector<std::uint8_t> table(G::max_index + 1);
  const int shift = in.byte();
  for (std::size_t i = 0; i < table.size(); ++i)
    table[i] = static_cast<std::uint8_t>((i + static_cast<unsigned>(shift)) & F::max_index);
  if (shift >= 0xFC) table.pop_back();
  // Now and then a mask of another size.
  const auto size = pair.source.size();
  const int more = in.choice(16) == 0 ? 1 : 0;
  std::vector<std::uint8_t> bits(static_cast<std::size_t>(size.width + more + 7) / 8U *
                                 static_cast<std::size_t>(size.height));
  for (std::size_t i = 0; i < bits.size(); ++i) bits[i] = static_cast<std::uint8_t>(key * i + i);
  Picture<image::Indexed1> mask;
  if (!pair.source.empty())
    mask = Picture<image::Indexed1>::over(bits, {size.width + more, size.height}).value();
  switch (in.choice(5)) {
    case 4:
      return copies(in, scene, pair, image::Masked<image::Indexed1, image::KeyedRemap>{mask, {key, table}});
    case 0:
      if constexpr (G::bits <= F::bits) return copies(in, scene, pair, image::Everything{});
      [[fallthrough]];
    case 1:
      if constexpr (G::bits <= F::bits) return copies(in, scene, pair, image::ColourKey{key});
      [[fallthrough]];
    case 2:
      return copies(in, scene, pair, image::Remap{table});
    default:
      return copies(in, scene, pair, image::KeyedRemap{key, table});
  }
}

}  // namespace

void run(Input in) {
  switch (in.choice(4)) {
    case 0:
      return rules<image::Indexed8, image::Indexed8>(in);
    case 1:
      return rules<image::Indexed2, image::Indexed2>(in);
    case 2:
      return rules<image::Indexed4Lsb, image::Indexed1>(in);
    default:
      return rules<image::Indexed1, image::Indexed1>(in);
  }
}

}  // namespace fuzz
