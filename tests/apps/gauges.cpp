// SPDX-License-Identifier: MIT
#include <tests/apps/program.hpp>

#include <array>
#include <firmware/apps/gauges/gauges.hpp>
#include <set>

namespace {

using namespace programs;
using apps::gauges::Gauges;
using apps::gauges::Readings;
using apps::gauges::readings_at;

constexpr std::array<std::uint32_t, 5> frames{0, 20, 57, 151, 1399};

template <class F>
using Finest = apps::gauges::TunedGauges<F, apps::gauges::FinestKnobs>;

// Each knob as far from the standard one as it goes.
struct CoarseKnobs : apps::gauges::DefaultKnobs {
  using Mixing = apps::MixCodes;
  static constexpr int wedges = 16;
  static constexpr int face_steps = 1;
  static constexpr apps::gauges::Edges edges = apps::gauges::Edges::box_2x2;
  static constexpr int edge_steps = 3;
};
struct HardKnobs : apps::gauges::FinestKnobs {
  static constexpr apps::gauges::Edges edges = apps::gauges::Edges::hard;
};
template <class F>
using Coarse = apps::gauges::TunedGauges<F, CoarseKnobs>;

TEST(Gauges, BandsEqualTheWholeFrame) {
  expect_bands_equal_frame<Gauges, image::Indexed8>(palette_screen({320, 240}, 256), frames);
  expect_bands_equal_frame<Gauges, image::Indexed8>(palette_screen({97, 133}, 256), frames);
  expect_bands_equal_frame<Gauges, image::Indexed4>(grey_screen<image::Indexed4>({128, 64}), frames);
  expect_bands_equal_frame<Gauges, image::Indexed2Lsb>(palette_screen({131, 70}, 4), frames);
  expect_bands_equal_frame<Gauges, image::Indexed1>(grey_screen<image::Indexed1>({96, 16}), frames);
}

// A panel on which no text fits, so that no font's version counts.
TEST(Gauges, StandardKnobsDrawWhatWasDrawnBeforeThereWereKnobs) {
  constexpr std::array<std::pair<std::uint32_t, std::uint32_t>, 5> before{
      {{20, 0xA598FA6D}, {57, 0x52B8EF27}, {151, 0xAA160E56}, {700, 0xF336E3EA}, {1399, 0xB890E76A}}};
  const Screen screen = palette_screen({93, 102}, 256);
  Gauges<image::Indexed8> app(screen.info());
  for (const auto& [frame, digest] : before) {
    app.update(frame);
    const auto pixels = drawn<Gauges<image::Indexed8>, image::Indexed8>(app, screen.size);
    const auto picture = image::Picture<image::Indexed8>::over(pixels, screen.size);
    EXPECT_EQ(image::digest(picture.value(), app.palette()), digest) << "frame " << frame;
  }
}

TEST(Gauges, TurnedKnobsKeepBandsAndFramesEqual) {
  expect_bands_equal_frame<Finest, image::Indexed8>(palette_screen({320, 240}, 256), frames);
  expect_bands_equal_frame<Coarse, image::Indexed8>(palette_screen({320, 240}, 256), frames);
  expect_bands_equal_frame<Finest, image::Indexed4>(palette_screen({161, 90}, 16), frames);
}

TEST(Gauges, TurnedKnobsAreSoundOnEveryScreen) {
  for (const linear::Size size : sizes) {
    expect_sound<Finest, image::Indexed8>(palette_screen(size, 256), 0, 600, 61);
    expect_sound<Finest, image::Indexed8>(palette_screen(size, 100), 0, 600, 153);
    expect_sound<Coarse, image::Indexed8>(palette_screen(size, 256), 0, 600, 153);
  }
}

// Without entries for their ramps edges are hard: the same pixels as with hard edges asked for.
TEST(Gauges, EdgesWithoutEntriesAreHard) {
  using Hard = apps::gauges::TunedGauges<image::Indexed8, HardKnobs>;
  for (const int entries : {16, 160, 256}) {
    const Screen screen = palette_screen({320, 240}, entries);
    const auto fine = std::make_unique<Finest<image::Indexed8>>(screen.info());
    const auto hard = std::make_unique<Hard>(screen.info());
    fine->update(151);
    hard->update(151);
    const bool same = drawn<Finest<image::Indexed8>, image::Indexed8>(*fine, screen.size) ==
                      drawn<Hard, image::Indexed8>(*hard, screen.size);
    EXPECT_EQ(same, entries < 256) << entries << " entries";
  }
}

TEST(Gauges, BitOrderAndStrideDontMatter) {
  using namespace image;
  expect_formats_agree<Gauges, Indexed4, Indexed4Lsb>(palette_screen({161, 90}, 16), frames);
  expect_formats_agree<Gauges, Indexed4, Indexed4Lsb>(grey_screen<Indexed4>({128, 64}), frames);
  expect_formats_agree<Gauges, Indexed2, Indexed2Lsb>(palette_screen({67, 130}, 4), frames);
  expect_formats_agree<Gauges, Indexed1, Indexed1Lsb>(grey_screen<Indexed1>({97, 33}), frames);
  expect_formats_agree<Gauges, Indexed8, Indexed8>(palette_screen({201, 100}, 256), frames);
}

TEST(Gauges, EveryFrameIsSoundOnEveryScreen) {
  for (const linear::Size size : sizes) {
    expect_sound<Gauges, image::Indexed8>(palette_screen(size, 256), 0, 600, 37);
    expect_sound<Gauges, image::Indexed4>(palette_screen(size, 16), 0, 600, 61);
    expect_sound<Gauges, image::Indexed4>(grey_screen<image::Indexed4>(size), 0, 600, 61);
    expect_sound<Gauges, image::Indexed2>(palette_screen(size, 4), 0, 600, 61);
    expect_sound<Gauges, image::Indexed1>(grey_screen<image::Indexed1>(size), 0, 600, 61);
  }
  expect_sound<Gauges, image::Indexed8>(palette_screen({640, 480}, 256), 0, 600, 150);
}

TEST(Gauges, SixHundredFramesAreSoundOnTheBoardsPanels) {
  expect_sound<Gauges, image::Indexed4>(grey_screen<image::Indexed4>({128, 64}), 0, 600, 1);
  expect_sound<Gauges, image::Indexed8>(palette_screen({320, 240}, 256), 0, 600, 5);
}

TEST(Gauges, PalettesOfAnySizeAreFilled) {
  for (const int entries : {2, 3, 16, 17, 100, 255, 256})
    expect_sound<Gauges, image::Indexed8>(palette_screen({120, 80}, entries), 100, 102, 1);
}

TEST(Gauges, IndicesStayInsideASmallPalette) {
  for (const int entries : {2, 5, 16, 60}) {
    const Screen screen = palette_screen({320, 240}, entries);
    const auto app = std::make_unique<Gauges<image::Indexed8>>(screen.info());
    app->update(300);
    const auto indices = drawn<Gauges<image::Indexed8>, image::Indexed8>(*app, screen.size);
    EXPECT_THAT(indices, testing::Each(testing::Lt(entries)));
  }
}

TEST(Gauges, AFrameDependsOnItsNumberAlone) {
  expect_function_of_frame<Gauges, image::Indexed8>(palette_screen({320, 240}, 256), frames);
  expect_function_of_frame<Gauges, image::Indexed4>(grey_screen<image::Indexed4>({128, 64}), frames);
  expect_function_of_frame<Gauges, image::Indexed1>(grey_screen<image::Indexed1>({96, 16}), frames);
}

// The fade, the arcs and the blinking lights are done by palette alone, so the pixels of these frames, in
// which no needle has moved yet, are the same, and their palettes are not.
TEST(Gauges, FadeTouchesNoPixel) {
  const Screen screen = palette_screen({320, 240}, 256);
  Gauges<image::Indexed8> app(screen.info());
  app.update(2);
  const auto first = drawn<Gauges<image::Indexed8>, image::Indexed8>(app, screen.size);
  const std::vector<std::uint8_t> dark(app.palette().begin(), app.palette().end());
  app.update(14);
  EXPECT_EQ(first, (drawn<Gauges<image::Indexed8>, image::Indexed8>(app, screen.size)));
  EXPECT_THAT(app.palette(), testing::Not(testing::ElementsAreArray(dark)));
  app.update(0);
  EXPECT_THAT(app.palette(), testing::Each(0));
}

TEST(Gauges, LightsAndOffAreToldApartOnEveryDepth) {
  // With two tones, too, a lit turn signal changes the picture.
  const Screen screen = grey_screen<image::Indexed1>({128, 64});
  Gauges<image::Indexed1> app(screen.info());
  const auto corner = [&](std::uint32_t frame) {
    app.update(frame);
    const auto picture = drawn<Gauges<image::Indexed1>, image::Indexed1>(app, screen.size);
    return std::vector<std::uint8_t>(picture.begin(), picture.begin() + 128 * 7);
  };
  EXPECT_NE(corner(apps::gauges::test_frames + 1), corner(apps::gauges::test_frames + 19));
}

TEST(Drive, ReadingsStayOnTheirScales) {
  using namespace apps::gauges;
  const auto check = [](std::uint32_t frame) {
    const Readings r = readings_at(frame);
    return r.speed >= 0 && r.speed <= speed_limit << value_bits && r.rpm >= 0 &&
           r.rpm <= rpm_limit << value_bits && r.gear >= 0 && r.gear <= 9 && r.fuel >= 0 && r.fuel <= 1000 &&
           r.heat >= 0 && r.heat <= 1000 && r.odometer >= 0 && r.odometer < 1'000'000'000 &&
           r.brightness >= 0 && r.brightness <= 256 && r.lights < 1U << light_count && r.runner >= 0 &&
           r.runner < 1000;
  };
  for (std::uint32_t frame = 0; frame < 30'000; ++frame) ASSERT_TRUE(check(frame)) << "frame " << frame;
  for (std::uint32_t back = 0; back < 3000; ++back)
    ASSERT_TRUE(check(0xFFFFFFFFU - back)) << "last but " << back;
}

TEST(Drive, NothingJumps) {
  using namespace apps::gauges;
  Readings before = readings_at(test_frames);
  for (std::uint32_t frame = test_frames + 1; frame < 20'000; ++frame) {
    const Readings now = readings_at(frame);
    ASSERT_LE(std::abs(now.speed - before.speed), 4 << value_bits) << "frame " << frame;
    ASSERT_LE(std::abs(now.rpm - before.rpm), 300 << value_bits) << "frame " << frame;
    ASSERT_GE(now.odometer, before.odometer) << "frame " << frame;
    ASSERT_LE(now.odometer - before.odometer, 2) << "frame " << frame;
    before = now;
  }
}

TEST(Layout, InstrumentsStayOnThePanelAndApart) {
  using namespace apps::gauges;
  using linear::Rect;
  for (int width = 1; width <= 700; width += width < 40 ? 1 : 13)
    for (int height = 1; height <= 500; height += height < 40 ? 1 : 11) {
      const Layout l = layout_for({width, height});
      const auto box = [](const DialPlace& d) {
        return d.radius == 0
                   ? Rect{}
                   : Rect{d.centre.x - d.radius, d.centre.y - d.radius, 2 * d.radius + 1, 2 * d.radius + 1};
      };
      const std::array<Rect, 7> boxes{box(l.speed), box(l.rpm), l.readout, l.fuel,
                                      l.heat,       l.odometer, l.lights};
      bool inside = true;
      bool apart = true;
      for (std::size_t i = 0; i < boxes.size(); ++i) {
        const Rect& a = boxes[i];
        if (a.width <= 0 || a.height <= 0) continue;
        inside = inside && a.x >= 0 && a.y >= 0 && a.x + a.width <= width && a.y + a.height <= height;
        for (std::size_t k = 0; k < i; ++k) {
          const Rect& b = boxes[k];
          if (b.width <= 0 || b.height <= 0) continue;
          apart = apart && (a.x >= b.x + b.width || b.x >= a.x + a.width || a.y >= b.y + b.height ||
                            b.y >= a.y + a.height);
        }
      }
      ASSERT_TRUE(inside) << width << "x" << height;
      ASSERT_TRUE(apart) << width << "x" << height;
      ASSERT_TRUE(l.speed.radius > 0 || !l.readout.empty()) << width << "x" << height;
    }
}

}  // namespace
