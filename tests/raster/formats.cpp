// SPDX-License-Identifier: MIT
//
// One picture, whatever holds it: all formats, both bit orders, strides, bands and sub-surfaces against the
// picture that spans alone draw.
#include <intaglio/raster/line.hpp>
#include <intaglio/raster/pixel.hpp>
#include <intaglio/raster/rectangle.hpp>
#include <intaglio/raster/solid.hpp>
#include <tests/oracle/random.hpp>

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

namespace {

using namespace intaglio;
using linear::Point;
using linear::Rect;

constexpr int width = 37;
constexpr int height = 29;

// Indices drawn by spans alone, one byte a pixel, with guards that no span may touch.
class Canvas {
 public:
  Canvas(const Rect& clip, bool flip) : clip_(clip), flip_(flip), pixels_(width * height) {}
  [[nodiscard]] const Rect& clip() const { return clip_; }
  void use(unsigned index) { index_ = index; }
  void span(int y, int begin, int end) {
    for (int x = begin; x < end; ++x) {
      unsigned& pixel = pixels_.at(static_cast<unsigned>(y * width + x));
      pixel = flip_ ? pixel ^ index_ : index_;
    }
  }
  [[nodiscard]] unsigned get(int x, int y) const { return pixels_.at(static_cast<unsigned>(y * width + x)); }

 private:
  Rect clip_;
  bool flip_;
  unsigned index_ = 0;
  std::vector<unsigned> pixels_;
};

// The same random drawing on any sink. Most shapes stick out of the picture.
template <class Use>
void draw_scene(unsigned seed, int shapes, unsigned indices, Use use) {
  oracle::Random random(seed);
  const auto value = [&](int low, int high) { return random.between(low, high); };
  for (int i = 0; i < shapes; ++i) {
    const unsigned index = static_cast<unsigned>(value(0, 255)) % indices;
    const int kind = value(0, 5);
    const Point a{value(-9, width + 9), value(-9, height + 9)};
    const Point b{value(-9, width + 9), value(-9, height + 9)};
    const Rect r{a.x, a.y, value(-1, 20), value(-1, 12)};
    use(index, [&](auto& sink) {
      switch (kind) {
        case 0:
          return raster::draw_pixel(sink, a);
        case 1:
          return raster::draw_horizontal(sink, a, r.width);
        case 2:
          return raster::draw_vertical(sink, a, r.height);
        case 3:
          return raster::fill_rect(sink, r);
        case 4:
          return raster::draw_rect(sink, r);
        default:
          return raster::draw_line(sink, a, b);
      }
    });
  }
}

template <class F, template <class> class Sink>
void expect_equal_to_spans(bool flip) {
  for (unsigned seed = 1; seed <= 40; ++seed) {
    const unsigned indices = F::max_index + 1;
    const Rect clip = seed % 2 == 0 ? Rect{0, 0, width, height} : Rect{5, 3, 23, 17};
    Canvas canvas(clip, flip);
    draw_scene(seed, 60, indices, [&](unsigned index, auto draw) {
      canvas.use(index);
      ASSERT_TRUE(draw(canvas).ok());
    });

    // Into the middle of a larger buffer, as a sub-surface that begins at any slot of a byte.
    const int stride = F::row_bytes(width) + 1 + static_cast<int>(seed % 5);
    std::vector<std::uint8_t> memory(static_cast<std::size_t>(stride * (height + 4)), 0xA5);
    const auto whole = image::Surface<F>::over(memory, {stride * F::pixels_per_byte, height + 4}, stride);
    ASSERT_TRUE(whole.ok());
    const int left = static_cast<int>(seed) % (F::pixels_per_byte + 1);
    const image::Surface<F> surface = whole.value().sub({left, 2, width, height});
    ASSERT_TRUE(raster::fill_rect(Sink<F>(surface, 0), {0, 0, width, height}).ok());
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) surface.set(x, y, 0);
    draw_scene(seed, 60, indices, [&](unsigned index, auto draw) {
      const Sink<F> sink(surface, index, clip);
      ASSERT_TRUE(draw(sink).ok());
    });
    int wrong = 0;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) wrong += surface.get(x, y) == canvas.get(x, y) ? 0 : 1;
    ASSERT_EQ(wrong, 0) << "seed " << seed;
    // Nothing outside: paint the surface with the pattern and find the memory as it was.
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        surface.set(x, y, 0xA5U >> F::shift((x + left) & (F::pixels_per_byte - 1)) & F::max_index);
    int damaged = 0;
    for (std::uint8_t byte : memory) damaged += byte == 0xA5 ? 0 : 1;
    ASSERT_EQ(damaged, 0) << "seed " << seed;

    // Band by band, in bands of 1 to 8 rows.
    const int rows = 1 + static_cast<int>(seed % 8);
    for (int top = 0; top < height; top += rows) {
      const Rect band{0, top, width, std::min(rows, height - top)};
      std::vector<std::uint8_t> strip(static_cast<std::size_t>(F::row_bytes(width) * band.height), 0);
      const auto target = image::Surface<F>::over_band(strip, band);
      ASSERT_TRUE(target.ok());
      draw_scene(seed, 60, indices, [&](unsigned index, auto draw) {
        const Sink<F> sink(target.value(), index, clip);
        ASSERT_TRUE(draw(sink).ok());
      });
      for (int y = top; y < band.bottom(); ++y)
        for (int x = 0; x < width; ++x) wrong += target.value().get(x, y) == canvas.get(x, y) ? 0 : 1;
    }
    ASSERT_EQ(wrong, 0) << "bands, seed " << seed;
  }
}

template <class F>
class Formats : public testing::Test {};
using AllFormats =
    testing::Types<image::Indexed1, image::Indexed2, image::Indexed4, image::Indexed8, image::Indexed1Lsb,
                   image::Indexed2Lsb, image::Indexed4Lsb, image::Indexed<8, image::BitOrder::lsb_first>>;
TYPED_TEST_SUITE(Formats, AllFormats);

TYPED_TEST(Formats, SolidDrawsWhatSpansDraw) { expect_equal_to_spans<TypeParam, raster::Solid>(false); }
TYPED_TEST(Formats, XorDrawsWhatSpansDraw) { expect_equal_to_spans<TypeParam, raster::Xor>(true); }

TYPED_TEST(Formats, XorTwiceRestoresEveryByte) {
  using F = TypeParam;
  std::vector<std::uint8_t> memory(static_cast<std::size_t>(F::row_bytes(width) * height));
  oracle::Random random(7);
  for (std::uint8_t& byte : memory) byte = static_cast<std::uint8_t>(random.between(0, 255));
  const std::vector<std::uint8_t> before = memory;
  const auto surface = image::Surface<F>::over(memory, {width, height});
  ASSERT_TRUE(surface.ok());
  const auto once = [&] {
    draw_scene(3, 1, F::max_index + 1, [&](unsigned, auto draw) {
      const raster::Xor sink(surface.value(), F::max_index);
      ASSERT_TRUE(draw(sink).ok());
    });
    draw_scene(11, 200, F::max_index + 1, [&](unsigned index, auto draw) {
      const raster::Xor sink(surface.value(), index);
      ASSERT_TRUE(draw(sink).ok());
    });
    const raster::Xor sink(surface.value(), F::max_index);
    ASSERT_TRUE(raster::draw_line(sink, {0, 0}, {width - 1, height - 1}).ok());
  };
  once();
  EXPECT_NE(memory, before);
  once();
  EXPECT_EQ(memory, before);
}

}  // namespace
