// SPDX-License-Identifier: MIT
#include <hal/sim/panel.hpp>
#include <intaglio/present/bands.hpp>
#include <intaglio/present/frame_writer.hpp>
#include <intaglio/raster/line.hpp>
#include <intaglio/raster/solid.hpp>

#include <gtest/gtest.h>

#include <limits>
#include <utility>
#include <vector>

namespace {

using hal::sim::PanelSpec;
using hal::sim::VirtualClock;
using intaglio::Argument;
using intaglio::Error;
using intaglio::Status;
using intaglio::image::Indexed1;
using intaglio::image::Indexed4;
using intaglio::image::Indexed8;
using intaglio::image::Picture;
using intaglio::image::Surface;
using intaglio::present::BandWriter;
using intaglio::present::FrameWriter;

PanelSpec write_panel(int width, int height, int bits, int y_alignment) {
  PanelSpec spec = hal::sim::paletted(width, height, bits, 0);
  spec.capabilities.y_alignment = y_alignment;
  return spec;
}

/// A fan of lines that cross every band, many of them leaving the frame.
template <class F>
Status draw_fan(const Surface<F>& target) {
  for (const int x : {-50, -3, 0, 7, 20, 31, 64, 90})
    for (const int y : {-40, 0, 9, 33, 70}) {
      const unsigned index = static_cast<unsigned>(x + y) & F::max_index;
      intaglio::raster::Solid<F> pen(target, index);
      if (const Status s = intaglio::raster::draw_line(pen, {x, y}, {40 - x, 35 - y}); !s.ok()) return s;
    }
  return {};
}

template <class F>
Status draw_all(const Surface<F>& target) {
  const auto bounds = target.bounds();
  for (int y = bounds.y; y < bounds.bottom(); ++y)
    for (int x = 0; x < bounds.width; ++x) target.set(x, y, 0);
  return draw_fan(target);
}

template <class F>
void bands_equal_full(const PanelSpec& spec) {
  const int width = spec.capabilities.width;
  const int height = spec.capabilities.height;
  VirtualClock clock;
  hal::sim::Panel whole(spec, clock);
  std::vector<std::uint8_t> memory(static_cast<std::size_t>(F::row_bytes(width) * height));
  FrameWriter<F> writer(whole, memory);
  auto begun = writer.begin();
  ASSERT_TRUE(draw_all(begun.value().surface()).ok());
  ASSERT_TRUE(writer.present(std::move(begun).value()).ok());

  for (int rows = spec.capabilities.y_alignment; rows <= height + 1; ++rows) {
    hal::sim::Panel panel(spec, clock);
    // A few bytes over don't make another row; what an earlier band left must not show.
    std::vector<std::uint8_t> part(static_cast<std::size_t>(F::row_bytes(width) * rows + 1), 0xA5);
    BandWriter<F> bands(panel, part);
    ASSERT_TRUE(bands.status().ok());
    int next = 0;
    const auto watch = [&next](const Picture<F>& band) {
      EXPECT_EQ(band.bounds().y, next);
      next = band.bounds().bottom();
    };
    ASSERT_TRUE(bands.present([](const Surface<F>& band) { return draw_all(band); }, {}, watch).ok());
    EXPECT_EQ(next, height);
    ASSERT_EQ(panel.displayed(), whole.displayed()) << rows << " rows a band";
  }
}

TEST(Bands, GiveTheSamePictureAsAWholeFrame) {
  bands_equal_full<Indexed8>(write_panel(41, 37, 8, 1));
  bands_equal_full<Indexed4>(write_panel(33, 64, 4, 1));
  bands_equal_full<Indexed1>(write_panel(65, 64, 1, 8));
  bands_equal_full<Indexed1>(write_panel(96, 20, 1, 8));
  bands_equal_full<Indexed4>(write_panel(17, 11, 4, 4));
}

TEST(Bands, RowsKeepTheAlignmentOfThePanel) {
  VirtualClock clock;
  hal::sim::Panel panel(write_panel(80, 60, 1, 8), clock);
  std::vector<std::uint8_t> memory(10 * 60);
  const auto rows_in = [&](std::size_t bytes) {
    return BandWriter<Indexed1>(panel, std::span(memory).first(bytes)).rows();
  };
  EXPECT_EQ(rows_in(80), 8);
  EXPECT_EQ(rows_in(159), 8);
  EXPECT_EQ(rows_in(160), 16);
  EXPECT_EQ(rows_in(599), 56);
  EXPECT_EQ(rows_in(600), 60);
}

TEST(Bands, MemoryForLessThanOneAlignedGroupSaysHowMuchIsNeeded) {
  VirtualClock clock;
  hal::sim::Panel panel(write_panel(80, 60, 1, 8), clock);
  std::vector<std::uint8_t> memory(79);
  BandWriter<Indexed1> bands(panel, memory);
  EXPECT_EQ(bands.status(), Status(Error::too_small, Argument::workspace, 80));
  EXPECT_EQ(bands.present([](const Surface<Indexed1>&) { return Status{}; }), bands.status());
  hal::sim::Panel low(write_panel(80, 5, 1, 8), clock);
  EXPECT_EQ(BandWriter<Indexed1>(low, std::span(memory).first(49)).status(),
            Status(Error::too_small, Argument::workspace, 50));
  EXPECT_EQ(BandWriter<Indexed1>(low, std::span(memory).first(50)).rows(), 5);
}

TEST(Bands, ScanOutAndOtherFormatsAreRefused) {
  VirtualClock clock;
  std::vector<std::uint8_t> memory(1000);
  hal::sim::Panel scan_out(hal::sim::paletted(8, 8, 8), clock);
  EXPECT_EQ(BandWriter<Indexed8>(scan_out, memory).status(), Status(Error::unsupported, Argument::panel));
  hal::sim::Panel other(write_panel(8, 8, 4, 1), clock);
  EXPECT_EQ(BandWriter<Indexed8>(other, memory).status(), Status(Error::mismatched, Argument::panel));
  EXPECT_EQ(BandWriter<Indexed4>(other, memory, -1).status(), Status(Error::out_of_range, Argument::count));
}

TEST(Bands, AnErrorOfTheDrawingEndsTheFrame) {
  VirtualClock clock;
  hal::sim::Panel panel(write_panel(8, 8, 8, 1), clock);
  std::vector<std::uint8_t> memory(8);
  BandWriter<Indexed8> bands(panel, memory);
  const Status wrong(Error::malformed, Argument::font);
  int calls = 0;
  const Status s = bands.present([&](const Surface<Indexed8>&) { return ++calls == 3 ? wrong : Status{}; });
  EXPECT_EQ(s, wrong);
  EXPECT_EQ(calls, 3);
}

TEST(BandCut, CoversThePictureInEveryDirectionWhateverTheMemory) {
  using hal::ScanDirection;
  for (const auto scan : {ScanDirection::down, ScanDirection::up, ScanDirection::left, ScanDirection::right})
    for (const int alignment : {1, 2, 3, 4})
      for (const int bits : {1, 4, 8}) {
        const bool sideways = scan == ScanDirection::left || scan == ScanDirection::right;
        const hal::Capabilities panel{.width = 23,
                                      .height = 17,
                                      .bits_per_pixel = bits,
                                      .x_alignment = alignment,
                                      .y_alignment = alignment,
                                      .scan = scan};
        const std::size_t least = intaglio::present::least_memory(panel, bits, sideways);
        EXPECT_EQ(intaglio::present::along_scan(panel, bits, least - 1).count, 0);
        std::size_t lines = 0;
        for (std::size_t memory = least; memory <= 23U * 17U; ++memory) {
          const auto cut = intaglio::present::along_scan(panel, bits, memory);
          int end = 0;  // Of the lines scanned so far.
          for (int step = 0; step < cut.count; ++step) {
            ASSERT_EQ(cut.first_scanned(panel, step), end);
            const auto band = cut.band(panel, step);
            ASSERT_LE(static_cast<std::size_t>((band.width * bits + 7) / 8 * band.height), memory);
            ASSERT_EQ((sideways ? band.x : band.y) % alignment, 0);
            ASSERT_EQ(sideways ? band.x * bits % 8 : 0, 0) << "whole bytes";
            end += cut.lines_of(band);
          }
          ASSERT_EQ(end, sideways ? 23 : 17);
          ASSERT_GE(static_cast<std::size_t>(cut.lines), lines) << "more memory, but fewer lines";
          lines = static_cast<std::size_t>(cut.lines);
        }
        for (const std::size_t memory : {std::size_t{23 * 17}, std::numeric_limits<std::size_t>::max()})
          EXPECT_EQ(intaglio::present::along_scan(panel, bits, memory).count, 1) << "all at once";
      }
}

}  // namespace
