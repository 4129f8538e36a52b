// SPDX-License-Identifier: MIT
#include <tests/apps/program.hpp>

#include <array>
#include <cstdlib>
#include <firmware/apps/map/map.hpp>

namespace {

using namespace programs;
using apps::map::Camera;
using apps::map::camera_at;
using apps::map::Coast;
using apps::map::Map;
using apps::map::Projection;

// The world; Europe from afar and near; over the date line; night; near the pole.
constexpr std::array<std::uint32_t, 6> frames{0, 60, 115, 620, 1033, 1200};

// Each knob as far from the standard one as it goes.
struct CoarseKnobs : apps::map::DefaultKnobs {
  using Mixing = apps::MixCodes;
  static constexpr int shortest = 1024;
  static constexpr int surf = 2;
  static constexpr int zone_stride = 16;
};
template <class F>
using Coarse = apps::map::TunedMap<F, CoarseKnobs>;

TEST(Map, BandsEqualTheWholeFrame) {
  expect_bands_equal_frame<Map, image::Indexed8>(palette_screen({320, 240}, 256), frames);
  expect_bands_equal_frame<Map, image::Indexed8>(palette_screen({97, 133}, 256), frames);
  expect_bands_equal_frame<Map, image::Indexed4>(grey_screen<image::Indexed4>({128, 64}), frames);
  expect_bands_equal_frame<Map, image::Indexed2Lsb>(palette_screen({131, 70}, 4), frames);
  expect_bands_equal_frame<Map, image::Indexed1>(grey_screen<image::Indexed1>({96, 16}), frames);
}

TEST(Map, TurnedKnobsKeepBandsAndFramesEqual) {
  expect_bands_equal_frame<Coarse, image::Indexed8>(palette_screen({320, 240}, 256), frames);
  expect_bands_equal_frame<Coarse, image::Indexed4>(palette_screen({161, 90}, 16), frames);
}

TEST(Map, BitOrderAndStrideDontMatter) {
  using namespace image;
  expect_formats_agree<Map, Indexed4, Indexed4Lsb>(palette_screen({161, 90}, 16), frames);
  expect_formats_agree<Map, Indexed4, Indexed4Lsb>(grey_screen<Indexed4>({128, 64}), frames);
  expect_formats_agree<Map, Indexed2, Indexed2Lsb>(palette_screen({67, 130}, 4), frames);
  expect_formats_agree<Map, Indexed1, Indexed1Lsb>(grey_screen<Indexed1>({97, 33}), frames);
  expect_formats_agree<Map, Indexed8, Indexed8>(palette_screen({201, 100}, 256), frames);
}

TEST(Map, EveryFrameIsSoundOnEveryScreen) {
  for (const linear::Size size : sizes) {
    expect_sound<Map, image::Indexed8>(palette_screen(size, 256), 0, 2250, 119);
    expect_sound<Map, image::Indexed4>(palette_screen(size, 16), 0, 2250, 211);
    expect_sound<Map, image::Indexed4>(grey_screen<image::Indexed4>(size), 0, 2250, 211);
    expect_sound<Map, image::Indexed2>(palette_screen(size, 4), 0, 2250, 211);
    expect_sound<Map, image::Indexed1>(grey_screen<image::Indexed1>(size), 0, 2250, 211);
  }
  expect_sound<Map, image::Indexed8>(palette_screen({640, 480}, 256), 0, 600, 150);
}

TEST(Map, SixHundredFramesAreSoundOnTheBoardsPanels) {
  expect_sound<Map, image::Indexed4>(grey_screen<image::Indexed4>({128, 64}), 0, 600, 1);
  expect_sound<Map, image::Indexed8>(palette_screen({320, 240}, 256), 0, 600, 5);
}

TEST(Map, AFrameDependsOnItsNumberAlone) {
  expect_function_of_frame<Map, image::Indexed8>(palette_screen({320, 240}, 256), frames);
  expect_function_of_frame<Map, image::Indexed4>(grey_screen<image::Indexed4>({128, 64}), frames);
}

// What the picture shows at a place: 1 land, 0 water, -1 something drawn over it, or outside the panel.
int shown_at(const std::vector<std::uint8_t>& picture, linear::Size size, const Projection& view,
             int longitude, int latitude) {
  namespace ink = apps::map::ink;
  const int x = apps::map::to_pixel(view.column(longitude * apps::map::units_per_degree / 10));
  const int y = apps::map::to_pixel(view.row(-latitude * apps::map::units_per_degree / 10));
  if (x < 0 || x >= size.width || y < 0 || y >= size.height) return -1;
  const int index = picture[static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) +
                            static_cast<std::size_t>(x)];
  if (index >= ink::lands) return 1;
  return index >= ink::oceans || index == ink::graticule ? 0 : -1;
}

struct Spot {
  const char* name;
  int longitude;  // 1/10 degree east
  int latitude;   // 1/10 degree north
  int land;
};

// Written from an atlas, not from the table. The Caspian is a hole; Chukotka, Wrangel and Antarctica lie on
// both sides of the date line, where the table's rings jump.
constexpr std::array<Spot, 34> spots{{
    {"Kansas", -980, 385, 1},
    {"Amazonas", -620, -40, 1},
    {"Sahara", 50, 230, 1},
    {"Congo", 230, 0, 1},
    {"Siberia", 1000, 620, 1},
    {"Tibet", 880, 320, 1},
    {"Australia", 1340, -250, 1},
    {"Greenland", -400, 720, 1},
    {"Germany", 105, 508, 1},
    {"Chukotka west", 1770, 665, 1},
    {"Chukotka east", -1760, 668, 1},
    {"Marie Byrd Land", -1450, -790, 1},
    {"Antarctica east", 1790, -855, 1},
    {"Antarctica west", -1790, -855, 1},
    {"Madagascar", 465, -200, 1},
    {"Anatolia", 330, 390, 1},
    {"Hokkaido", 1430, 434, 1},
    {"South Island", 1708, -438, 1},
    {"Iceland", -185, 649, 1},
    {"Borneo", 1140, 10, 1},
    {"Caspian Sea", 507, 420, 0},
    {"Atlantic", -350, 300, 0},
    {"Pacific", -1400, 200, 0},
    {"Pacific, date line", 1800, 300, 0},
    {"Bering Sea west", 1780, 580, 0},
    {"Bering Sea east", -1780, 580, 0},
    {"Indian Ocean", 800, -250, 0},
    {"Black Sea", 340, 432, 0},
    {"Mediterranean", 180, 350, 0},
    {"Hudson Bay", -860, 585, 0},
    {"Tasman Sea", 1600, -400, 0},
    {"Gulf of Mexico", -900, 255, 0},
    {"Southern Ocean", 1795, -600, 0},
    {"Arctic Ocean", 1795, 760, 0},
}};

TEST(Map, LandAndWaterStandWhereTheAtlasHasThem) {
  const Screen screen = palette_screen({640, 480}, 256);
  Map<image::Indexed8> app(screen.info());
  std::array<int, spots.size()> looks{};
  for (std::uint32_t frame = 0; frame < 2250; frame += 30) {
    app.update(frame);
    const auto picture = drawn<Map<image::Indexed8>, image::Indexed8>(app, screen.size);
    const Projection view(camera_at(frame, screen.size), screen.size);
    for (std::size_t i = 0; i < spots.size(); ++i)
      for (const int copy : {-3600, 0, 3600}) {
        const int shown = shown_at(picture, screen.size, view, spots[i].longitude + copy, spots[i].latitude);
        if (shown < 0) continue;
        ++looks[i];
        EXPECT_EQ(shown, spots[i].land) << spots[i].name << " at " << name(screen.size, frame);
      }
  }
  for (std::size_t i = 0; i < spots.size(); ++i)
    EXPECT_GT(looks[i], 0) << spots[i].name << " was never in sight";
}

// The board oled has 64 KiB of RAM for stack, frame and program.
static_assert(sizeof(Map<image::Indexed4>) <= 40 * 1024);

// The widest piece of land, and how it lies on a panel.
TEST(Map, MostVerticesOfAContinentLieThousandsOfPixelsOutsideAtTheDeepestZoom) {
  constexpr linear::Size size{320, 240};
  constexpr std::uint32_t at_the_cape = 1942;
  const Projection view(camera_at(at_the_cape, size), size);
  auto coast = std::make_unique<Coast>();
  std::size_t largest = 0;
  std::size_t beyond = 0;
  for (int i = 0; i < apps::map::piece_count; ++i) {
    if (!coast->find(i, 0, view, {0, 0, size.width, size.height})) continue;
    if (coast->vertices().size() <= largest) continue;
    largest = coast->vertices().size();
    beyond = 0;
    for (const linear::SubPoint v : coast->vertices()) {
      const int x = v.x / 256;
      const int y = v.y / 256;
      beyond += x < -1000 || x > size.width + 1000 || y < -1000 || y > size.height + 1000 ? 1U : 0U;
    }
  }
  EXPECT_EQ(largest, std::size_t{apps::map::land::largest_polygon});
  EXPECT_GT(beyond * 2, largest);
}

// Straight from the rule: the first vertex of a contour, and those that are far enough from the last kept.
TEST(Coast, LeavesOutVerticesNearTheLastKeptOne) {
  constexpr linear::Size size{320, 240};
  constexpr linear::Rect window{0, 0, size.width, size.height};
  constexpr int shortest = 512;
  const Projection view(camera_at(60, size), size);
  auto whole = std::make_unique<Coast>();
  auto thin = std::make_unique<Coast>();
  std::size_t vertices = 0;
  std::size_t left = 0;
  for (int i = 0; i < apps::map::piece_count; ++i) {
    if (!whole->find(i, 0, view, window)) continue;
    ASSERT_TRUE(thin->find(i, 0, view, window, shortest));
    std::vector<linear::SubPoint> expected;
    std::vector<int> lengths;
    std::size_t at = 0;
    for (std::size_t contour = 0; contour < whole->contour_lengths().size(); ++contour) {
      const std::size_t first = expected.size();
      for (int k = 0; k < whole->contour_lengths()[contour]; ++k, ++at) {
        const linear::SubPoint v = whole->vertices()[at];
        if (k > 0 && std::abs(v.x - expected.back().x) < shortest &&
            std::abs(v.y - expected.back().y) < shortest)
          continue;
        expected.push_back(v);
      }
      lengths.push_back(static_cast<int>(expected.size() - first));
    }
    EXPECT_TRUE(std::equal(expected.begin(), expected.end(), thin->vertices().begin(), thin->vertices().end(),
                           [](const auto& a, const auto& b) { return a.x == b.x && a.y == b.y; }))
        << "piece " << i;
    EXPECT_TRUE(std::equal(lengths.begin(), lengths.end(), thin->contour_lengths().begin(),
                           thin->contour_lengths().end()));
    vertices += whole->vertices().size();
    left += thin->vertices().size();
  }
  EXPECT_GT(left, 300U);
  EXPECT_LT(left * 2, vertices);
}

// Else the filling in halves, which the bands' test compares with small bands, would never run.
TEST(Map, AContinentOnALargePanelNeedsMoreEdgesThanTheWorkspaceHolds) {
  constexpr linear::Size size{640, 480};
  const Projection view(camera_at(0, size), size);
  auto coast = std::make_unique<Coast>();
  std::uint32_t most = 0;
  for (int i = 0; i < apps::map::piece_count; ++i) {
    if (!coast->find(i, 0, view, {0, 0, size.width, size.height})) continue;
    const auto needed = raster::polygon_workspace(coast->vertices(), coast->contour_lengths(),
                                                  {0, 0, size.width, size.height});
    ASSERT_TRUE(needed.ok());
    most = std::max(most, needed.value());
  }
  EXPECT_GT(most, 640U);
  constexpr std::array<std::uint32_t, 1> first{0};
  expect_bands_equal_frame<Map, image::Indexed8>(palette_screen(size, 256), first);
}

TEST(Map, EveryVertexStaysInTheDomainOnAnyPanel) {
  auto coast = std::make_unique<Coast>();
  for (const linear::Size size :
       {linear::Size{1, 1}, {1, 5000}, {5000, 1}, {4096, 4096}, {1 << 20, 1 << 20}, {1 << 20, 1}})
    for (std::uint32_t frame = 0; frame < 2250; frame += 25) {
      const Projection view(camera_at(frame, size), size);
      for (int copy = -2; copy <= 2; ++copy)
        for (const int i : {7, 90, 20}) {
          if (!coast->find(i, copy, view, {-(1 << 20), -(1 << 20), 1 << 21, 1 << 21})) continue;
          bool inside = true;
          for (const linear::SubPoint v : coast->vertices()) inside = inside && linear::in_domain(v);
          ASSERT_TRUE(inside) << name(size, frame) << " piece " << i << " copy " << copy;
        }
    }
}

TEST(Tour, TheCameraNeverJumps) {
  constexpr linear::Size size{320, 240};
  Camera before = camera_at(0, size);
  for (std::uint32_t frame = 1; frame < 5000; ++frame) {
    const Camera now = camera_at(frame, size);
    constexpr int world = apps::map::world_width * 256;
    int dx = std::abs(now.x - before.x);
    if (dx > world / 2) dx = world - dx;
    const auto pixels = [&](int distance, std::int64_t scale) { return (distance * scale) >> 32; };
    ASSERT_LE(pixels(dx, now.scale_x), 24) << "frame " << frame;
    ASSERT_LE(pixels(std::abs(now.y - before.y), now.scale_y), 24) << "frame " << frame;
    ASSERT_LE(std::abs(now.zoom - before.zoom), 32) << "frame " << frame;
    ASSERT_LE(std::abs(now.x), world / 2) << "frame " << frame;
    before = now;
  }
}

TEST(Tour, TheLastFramesOfAllAreLikeAnyOther) {
  for (std::uint32_t back = 0; back < 200; ++back) {
    const Camera camera = camera_at(0xFFFFFFFFU - back, {320, 240});
    ASSERT_GT(camera.scale_x, 0);
    ASSERT_GE(camera.night, 0);
    ASSERT_LE(camera.night, 256);
  }
}

TEST(Legend, PlacesReadAsOnAChart) {
  Camera camera;
  camera.x = (12 * 180 + 30 * 3) * 256;
  camera.y = -(41 * 180 + 54 * 3) * 256;
  EXPECT_EQ(apps::map::place_text(camera).text(), "41°54'N 12°30'E");
  camera.x = -camera.x;
  camera.y = -camera.y;
  EXPECT_EQ(apps::map::place_text(camera).text(), "41°54'S 12°30'W");
  camera.y = -(9 * 180 + 179) * 256 - 255;  // rounds up to the next degree
  camera.x = 0;
  EXPECT_EQ(apps::map::place_text(camera).text(), "10°00'N 0°00'E");
}

TEST(Legend, TheScaleBarIsAsLongAsItSays) {
  for (std::uint32_t frame = 0; frame < 600; frame += 20) {
    const Camera camera = camera_at(frame, {320, 240});
    const auto bar = apps::map::scale_bar(camera, 80);
    ASSERT_GT(bar.pixels, 20) << "frame " << frame;
    ASSERT_LE(bar.pixels, 80) << "frame " << frame;
    // Kilometres of one pixel, from the equator's 40,030 km by the pixels of 360 degrees.
    const double world = static_cast<double>(camera.scale_y) * 64800 / 65536 / 256;
    EXPECT_NEAR(bar.pixels, bar.kilometres * world / 40030, 1.0) << "frame " << frame;
  }
}

}  // namespace
