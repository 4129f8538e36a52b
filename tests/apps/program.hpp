// SPDX-License-Identifier: MIT
//
// What every program must do on every screen, as checks that take the program as a template.
#pragma once

#include <intaglio/image/digest.hpp>
#include <intaglio/image/surface.hpp>
#include <intaglio/present/screen_info.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace programs {

using namespace intaglio;

/// A screen of a size, and how its colours come about.
struct Screen {
  linear::Size size;
  int entries = 0;                    ///< 0: a fixed ramp of greys
  std::vector<std::uint8_t> greys{};  ///< that ramp

  [[nodiscard]] present::ScreenInfo info() const { return {size, entries, greys}; }
};

/// A screen with as many greys as the format has indices.
template <class F>
Screen grey_screen(linear::Size size) {
  Screen screen{size, 0, {}};
  for (unsigned i = 0; i <= F::max_index; ++i)
    screen.greys.insert(screen.greys.end(), 3, static_cast<std::uint8_t>(i * 255U / F::max_index));
  return screen;
}

inline Screen palette_screen(linear::Size size, int entries) { return {size, entries, {}}; }

/// The indices of a frame, row by row, drawn in bands of `band` rows (0: at once), rows `slack` bytes longer
/// than needed, on memory full of `before`. Expects that the program reports no error and leaves the slack
/// alone.
template <class App, class F>
std::vector<std::uint8_t> drawn(const App& app, linear::Size size, int band = 0, int slack = 0,
                                std::uint8_t before = 0) {
  std::vector<std::uint8_t> indices;
  if (band == 0) band = size.height;
  const int stride = F::row_bytes(size.width) + slack;
  for (int y = 0; y < size.height; y += band) {
    const int rows = y + band < size.height ? band : size.height - y;
    std::vector<std::uint8_t> memory(static_cast<std::size_t>(stride) * static_cast<std::size_t>(rows),
                                     before);
    const auto surface = image::Surface<F>::over_band(memory, {0, y, size.width, rows}, stride);
    EXPECT_TRUE(surface.ok());
    const Status status = app.draw(surface.value());
    EXPECT_TRUE(status.ok()) << "error " << static_cast<int>(status.error()) << " argument "
                             << static_cast<int>(status.argument()) << " needed " << status.needed();
    bool outside = false;
    for (auto row = memory.begin(); row != memory.end(); row += stride)
      outside = outside || std::any_of(row + F::row_bytes(size.width), row + stride,
                                       [before](std::uint8_t byte) { return byte != before; });
    EXPECT_FALSE(outside) << "drawn beyond the end of a row";
    for (int row = 0; row < rows; ++row)
      for (int x = 0; x < size.width; ++x)
        indices.push_back(static_cast<std::uint8_t>(surface.value().get(x, y + row)));
  }
  return indices;
}

/// A name for messages.
inline std::string name(linear::Size size, std::uint32_t frame) {
  return std::to_string(size.width) + "x" + std::to_string(size.height) + " frame " + std::to_string(frame);
}

/// Bands of several heights give the picture of the whole frame, whatever was in memory before.
template <template <class> class App, class F>
void expect_bands_equal_frame(const Screen& screen, std::span<const std::uint32_t> frames) {
  const auto app = std::make_unique<App<F>>(screen.info());
  for (const std::uint32_t frame : frames) {
    app->update(frame);
    const auto whole = drawn<App<F>, F>(*app, screen.size);
    for (const int band : {1, 3, 8, 17, 50}) {
      const auto banded = drawn<App<F>, F>(*app, screen.size, band, 0, 0xFF);
      EXPECT_TRUE(whole == banded) << name(screen.size, frame) << " in bands of " << band;
    }
  }
}

/// Formats of the same depth give the same indices, strides don't matter.
template <template <class> class App, class A, class B>
void expect_formats_agree(const Screen& screen, std::span<const std::uint32_t> frames) {
  const auto a = std::make_unique<App<A>>(screen.info());
  const auto b = std::make_unique<App<B>>(screen.info());
  for (const std::uint32_t frame : frames) {
    a->update(frame);
    b->update(frame);
    EXPECT_TRUE((drawn<App<A>, A>(*a, screen.size)) == (drawn<App<B>, B>(*b, screen.size, 0, 5, 0xA5)))
        << name(screen.size, frame);
  }
}

/// No frame reports an error, none leaves a pixel undrawn, and the palette has the size the screen asks for.
template <template <class> class App, class F>
void expect_sound(const Screen& screen, std::uint32_t first, std::uint32_t end, std::uint32_t step) {
  const auto app = std::make_unique<App<F>>(screen.info());
  for (std::uint32_t frame = first; frame < end; frame += step) {
    app->update(frame);
    EXPECT_EQ(app->palette().size(), static_cast<std::size_t>(screen.entries) * 3U);
    const auto on_zeros = drawn<App<F>, F>(*app, screen.size, 0, 1, 0x00);
    const auto on_ones = drawn<App<F>, F>(*app, screen.size, 0, 1, 0xFF);
    ASSERT_TRUE(on_zeros == on_ones) << name(screen.size, frame) << ": a pixel was not drawn";
  }
}

/// The digest of a frame, as the simulator and the boards print it.
template <class App, class F>
std::uint32_t digest_of(const App& app, const Screen& screen) {
  std::vector<std::uint8_t> memory(static_cast<std::size_t>(F::row_bytes(screen.size.width)) *
                                   static_cast<std::size_t>(screen.size.height));
  const auto surface = image::Surface<F>::over(memory, screen.size);
  EXPECT_TRUE(app.draw(surface.value()).ok());
  return image::digest(image::Picture<F>(surface.value()),
                       screen.entries == 0 ? std::span<const std::uint8_t>(screen.greys) : app.palette());
}

/// A frame is the same whatever was shown before it.
template <template <class> class App, class F>
void expect_function_of_frame(const Screen& screen, std::span<const std::uint32_t> frames) {
  const auto straight = std::make_unique<App<F>>(screen.info());
  for (const std::uint32_t frame : frames) {
    const auto jumping = std::make_unique<App<F>>(screen.info());
    jumping->update(frame + 12345U);
    jumping->update(7);
    jumping->update(frame);
    straight->update(frame);
    EXPECT_EQ((digest_of<App<F>, F>(*straight, screen)), (digest_of<App<F>, F>(*jumping, screen)))
        << name(screen.size, frame);
  }
}

inline constexpr linear::Size sizes[] = {{1, 1},    {2, 1},     {1, 7},     {5, 5},    {13, 9},    {96, 16},
                                         {97, 33},  {64, 48},   {128, 64},  {30, 200}, {160, 128}, {200, 100},
                                         {256, 32}, {480, 100}, {240, 320}, {320, 240}};

}  // namespace programs
