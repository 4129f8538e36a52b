// SPDX-License-Identifier: MIT
//
// The properties that every primitive has, checked for one call of it in one window:
// - spans lie inside the sink's clip, and no pixel is drawn twice;
// - a call that fails draws nothing, and fails in every window;
// - under a smaller clip it draws the same, cut;
// - on a surface of any format it draws the same pixels and no other bit of the memory changes;
// - exclusive-or twice restores.
#pragma once

#include <intaglio/linear/rect.hpp>
#include <intaglio/raster/solid.hpp>
#include <intaglio/status.hpp>
#include <tests/fuzz/input.hpp>
#include <tests/oracle/packed.hpp>
#include <tests/oracle/recording_sink.hpp>

#include <algorithm>
#include <vector>

namespace fuzz {

using intaglio::Status;
using intaglio::linear::Point;
using intaglio::linear::Rect;
using intaglio::linear::SubPoint;

/// A window, and a clip in or across it.
struct Scene {
  Rect window;
  Rect clip;     ///< Anything.
  Rect visible;  ///< What the two have in common; perhaps nothing.

  explicit Scene(Input& in, int most_columns = 48, int most_rows = 32) {
    window.width = 1 + in.choice(most_columns);
    window.height = 1 + in.choice(most_rows);
    constexpr int limit = intaglio::linear::coordinate_limit;
    const auto corner = [&](int length) {
      // The window itself must lie in the domain.
      return std::clamp(in.coordinate(0, 0), -limit, limit - length);
    };
    if (in.byte() > 0xE0) window.x = corner(window.width), window.y = corner(window.height);
    clip.x = in.coordinate(window.x, window.width);
    clip.y = in.coordinate(window.y, window.height);
    clip.width = in.length();
    clip.height = in.length();
    visible = common();
  }

  // In this order, whatever the compiler: arguments of a call have none.
  [[nodiscard]] Point point(Input& in) const {
    const int x = in.coordinate(window.x, window.width);
    return {x, in.coordinate(window.y, window.height)};
  }
  [[nodiscard]] SubPoint sub_point(Input& in) const {
    const int x = in.sub_coordinate(window.x, window.width);
    return {x, in.sub_coordinate(window.y, window.height)};
  }
  /// True where an oracle may look at every pixel.
  [[nodiscard]] bool small() const { return window.width * window.height <= 256; }

 private:
  [[nodiscard]] Rect common() const {
    constexpr std::int64_t limit = intaglio::linear::coordinate_limit;
    const auto bad = [](std::int64_t value, std::int64_t most) { return value > most || value < -most; };
    if (bad(clip.x, limit) || bad(clip.y, limit) || bad(clip.width, 2 * limit) || bad(clip.height, 2 * limit))
      return {};
    const int left = std::max(clip.x, window.x);
    const int top = std::max(clip.y, window.y);
    const int right = std::min(clip.x + clip.width, window.x + window.width);
    const int bottom = std::min(clip.y + clip.height, window.y + window.height);
    if (left >= right || top >= bottom) return {};
    return {left, top, right - left, bottom - top};
  }
};

/// What a call drew in the whole window.
struct Drawn {
  Status status;
  oracle::RecordingSink sink;
  [[nodiscard]] bool has(int x, int y) const { return sink.writes(x, y) > 0; }
};

/// Calls `draw(sink)` on the whole window.
template <class Draw>
Drawn drawn(const Rect& window, Draw draw, int most = 1) {
  Drawn result{{}, oracle::RecordingSink(window)};
  result.status = draw(result.sink);
  require(result.sink.violation().empty(), result.sink.violation());
  require(result.sink.most() <= most, "a pixel drawn twice");
  require(result.status.ok() || result.sink.spans() == 0, "a call that fails draws");
  return result;
}

/// Calls `visit(x, y)` for all pixels.
template <class Visit>
void for_pixels(const Rect& area, Visit visit) {
  for (int y = area.y; y < area.y + area.height; ++y)
    for (int x = area.x; x < area.x + area.width; ++x) visit(x, y);
}

inline void require_same(const Drawn& a, const Drawn& b, std::string_view what) {
  require(a.sink.all_writes() == b.sink.all_writes(), what);
}

template <class F, template <class> class Sink, class Draw>
void check_surface(const Scene& scene, const Drawn& whole, int padding, unsigned index, Draw draw) {
  const Rect& window = scene.window;
  const int least = F::row_bytes(window.width);
  const int stride = least + padding;
  oracle::Packed expected(F::bits, F::order == intaglio::image::BitOrder::msb_first, stride, window.height);
  std::fill(expected.bytes().begin(), expected.bytes().end(), std::uint8_t{0xA5});
  expected.bytes().resize(static_cast<std::size_t>(stride * (window.height - 1) + least));
  std::vector<std::uint8_t> memory = expected.bytes();
  const std::vector<std::uint8_t> before = memory;
  auto surface = intaglio::image::Surface<F>::over_band(memory, window, stride);
  require(surface.ok(), "a surface over a window is refused");
  const Sink<F> sink(surface.value(), index, scene.clip);
  require(draw(sink) == whole.status, "another status on a surface");
  constexpr bool flips = std::is_same_v<Sink<F>, intaglio::raster::Xor<F>>;
  for_pixels(scene.visible, [&](int x, int y) {
    const int times = whole.sink.writes(x, y);
    if (times == 0 || (flips && times % 2 == 0)) return;
    const int column = x - window.x;
    const int row = y - window.y;
    expected.set(column, row, flips ? expected.get(column, row) ^ index : index);
  });
  require(memory == expected.bytes(), "memory isn't as the spans say");
  if constexpr (flips) {
    draw(sink).ignore();
    require(memory == before, "exclusive-or twice doesn't restore");
  }
}

/// Checks one call, `draw(sink)` for any sink, and returns what it drew. `most` is how often it may draw a
/// pixel (more than once only for text, whose glyphs may overlap).
template <class Draw>
Drawn check(const Scene& scene, Input& in, Draw draw, int most = 1) {
  using namespace intaglio;
  Drawn whole = drawn(scene.window, draw, most);
  const Drawn part = drawn(scene.visible, draw, most);
  require(part.status == whole.status, "another status under a clip");
  for_pixels(scene.visible, [&](int x, int y) {
    if (part.sink.writes(x, y) != whole.sink.writes(x, y)) report("another picture under a clip");
  });
  const int kind = in.byte();
  const int padding = kind >> 4 & 3;
  const auto index = static_cast<unsigned>(in.byte());
  switch (kind % 5) {
    case 0:
      check_surface<image::Indexed8, raster::Solid>(scene, whole, padding, index, draw);
      break;
    case 1:
      check_surface<image::Indexed8, raster::Xor>(scene, whole, padding, index, draw);
      break;
    case 2:
      check_surface<image::Indexed4Lsb, raster::Solid>(scene, whole, padding, index & 15U, draw);
      break;
    case 3:
      check_surface<image::Indexed2, raster::Xor>(scene, whole, padding, index & 3U, draw);
      break;
    default:
      check_surface<image::Indexed1, raster::Solid>(scene, whole, padding, index & 1U, draw);
  }
  return whole;
}

}  // namespace fuzz
