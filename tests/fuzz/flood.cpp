// SPDX-License-Identifier: MIT
//
// Flood fills in little and growing memory, against a search pixel by pixel.
#include <intaglio/raster/flood.hpp>
#include <tests/fuzz/scene.hpp>
#include <tests/oracle/flood.hpp>

namespace fuzz {
namespace {

using namespace intaglio;
using raster::Connectivity;
using raster::Flood;
using raster::FloodSpan;
using raster::Solid;

/// Stores the sink's index, and reports pixels drawn twice or outside.
template <class F>
class Once {
 public:
  Once(const Solid<F>& sink, const Rect& window)
      : sink_(sink), window_(window), drawn_(static_cast<std::size_t>(window.width * window.height)) {}
  [[nodiscard]] const Rect& clip() const { return sink_.clip(); }
  void span(int y, int begin, int end) {
    const Rect& clip = sink_.clip();
    require(begin < end && begin >= clip.x && end <= clip.right() && y >= clip.y && y < clip.bottom(),
            "a span outside the clip");
    for (int x = begin; x < end; ++x) {
      require(!has(x, y), "a pixel filled twice");
      drawn_[index(x, y)] = true;
    }
    sink_.span(y, begin, end);
  }
  [[nodiscard]] bool has(int x, int y) const { return drawn_[index(x, y)]; }

 private:
  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>((y - window_.y) * window_.width + (x - window_.x));
  }
  Solid<F> sink_;
  Rect window_;
  std::vector<bool> drawn_;
};

template <class F>
void flood(Input& in) {
  const Scene scene(in, 24, 20);
  const Rect& window = scene.window;
  const auto connectivity = static_cast<Connectivity>(in.choice(16) == 15 ? 2 : in.choice(2));
  const Point seed = scene.point(in);
  const bool interior = in.choice(2) == 0;
  const auto fill = static_cast<unsigned>(in.byte()) & F::max_index;
  const unsigned border = static_cast<unsigned>(in.byte()) % (F::max_index + 2);
  std::size_t room = static_cast<std::size_t>(in.choice(8));
  // The rest is the picture, over and over.
  const auto pattern = in.rest();
  std::vector<std::uint8_t> memory(static_cast<std::size_t>(F::row_bytes(window.width) * window.height));
  for (std::size_t i = 0; i < memory.size() && !pattern.empty(); ++i)
    memory[i] = static_cast<std::uint8_t>(pattern[i % pattern.size()] + i / pattern.size());
  const std::vector<std::uint8_t> before = memory;
  const auto surface = image::Surface<F>::over_band(memory, window).value();
  const auto picture = image::Picture<F>::over_band(before, window).value();
  const Solid<F> solid(surface, fill, scene.clip);
  Once<F> sink(solid, window);

  auto made = interior ? Flood<F>::interior(surface, connectivity, seed, fill)
                       : Flood<F>::up_to(border, surface, connectivity, seed, fill);
  if (!made.ok()) {
    require(memory == before, "a call that fails draws");
    return;
  }
  Flood<F>& work = made.value();
  std::vector<FloodSpan> workspace(room);
  Status status;
  int calls = 0;
  while (!(status = work.run(sink, workspace)).ok()) {
    require(status.error() == Error::too_small && status.argument() == Argument::workspace,
            "a flood fails otherwise than for lack of memory");
    require(status.needed() > workspace.size(), "more memory is needed than there is, but not more");
    require(++calls <= window.width * window.height + 1, "a flood that never ends");
    workspace.resize(status.needed());
  }
  const bool seen = scene.visible.contains(seed);
  const unsigned kind = seen ? picture.get(seed.x, seed.y) : 0;
  const auto reached = oracle::region(
      window.width, window.height,
      {scene.visible.x - window.x, scene.visible.y - window.y, scene.visible.width, scene.visible.height},
      connectivity == Connectivity::eight, seen ? seed.x - window.x : -1, seen ? seed.y - window.y : -1,
      [&](int x, int y) {
        const unsigned index = picture.get(x + window.x, y + window.y);
        return index != fill && (interior ? index == kind : index != border);
      });
  for_pixels(window, [&](int x, int y) {
    const bool expected =
        reached[static_cast<std::size_t>((y - window.y) * window.width + x - window.x)] != 0;
    require(sink.has(x, y) == expected, "not the region of the seed");
    require(surface.get(x, y) == (expected ? fill : picture.get(x, y)), "another index than the fill's");
  });
}

}  // namespace

void run(Input in) {
  switch (in.choice(3)) {
    case 0:
      return flood<image::Indexed8>(in);
    case 1:
      return flood<image::Indexed2>(in);
    default:
      return flood<image::Indexed1Lsb>(in);
  }
}

}  // namespace fuzz
