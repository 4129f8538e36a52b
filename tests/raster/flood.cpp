// SPDX-License-Identifier: MIT
#include <intaglio/raster/flood.hpp>
#include <intaglio/raster/line.hpp>
#include <tests/image/formats.hpp>
#include <tests/oracle/flood.hpp>
#include <tests/oracle/random.hpp>

#include <climits>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace {

using namespace intaglio;
using linear::Point;
using linear::Rect;
using raster::Connectivity;
using raster::Flood;
using raster::FloodSpan;
using raster::Solid;

// A picture of one index a pixel.
struct Plain {
  int width;
  int height;
  std::vector<unsigned> pixels;

  Plain(int w, int h) : width(w), height(h), pixels(static_cast<std::size_t>(w * h)) {}
  unsigned& at(int x, int y) { return pixels[static_cast<std::size_t>(y * width + x)]; }
  [[nodiscard]] unsigned at(int x, int y) const { return pixels[static_cast<std::size_t>(y * width + x)]; }
};

// How a fill is done in a test.
struct Task {
  Rect clip;
  bool eight = false;
  Point seed;
  unsigned fill = 1;
  int border = -1;  // interior-defined if negative
  std::size_t capacity = 0;
  bool grows = true;  // the workspace, when it is too small: to what the status says
};

// A sink that stores an index, and counts.
template <class F>
class Recorder {
 public:
  Recorder(const Solid<F>& sink, int width, int height)
      : sink_(sink), width_(width), counts_(static_cast<std::size_t>(width * height)) {}
  [[nodiscard]] const Rect& clip() const { return sink_.clip(); }
  void span(int y, int begin, int end) {
    ++spans_;
    const Rect& area = clip();
    if (begin >= end || begin < area.x || end > area.right() || y < area.y || y >= area.bottom()) {
      bad_ = true;
      return;
    }
    for (int x = begin; x < end; ++x) ++counts_[static_cast<std::size_t>(y * width_ + x)];
    sink_.span(y, begin, end);
  }
  [[nodiscard]] const std::vector<int>& counts() const { return counts_; }
  [[nodiscard]] int spans() const { return spans_; }
  [[nodiscard]] bool bad() const { return bad_; }

 private:
  Solid<F> sink_;
  int width_;
  std::vector<int> counts_;
  int spans_ = 0;
  bool bad_ = false;
};

std::vector<int> region(const Plain& picture, const Task& task) {
  if (task.seed.x < 0 || task.seed.y < 0 || task.seed.x >= picture.width || task.seed.y >= picture.height)
    return std::vector<int>(picture.pixels.size());
  const unsigned target = picture.at(task.seed.x, task.seed.y);
  return oracle::region(
      picture.width, picture.height, task.clip, task.eight, task.seed.x, task.seed.y, [&](int x, int y) {
        const unsigned index = picture.at(x, y);
        if (index == task.fill) return false;
        return task.border < 0 ? index == target : index != static_cast<unsigned>(task.border);
      });
}

// Largest workspace that any fill came to need.
std::size_t most_entries = 0;

// What is wrong with the fill; empty if nothing is.
template <class F>
std::string fault(const Plain& picture, const Task& task) {
  const std::string what = "seed " + std::to_string(task.seed.x) + "," + std::to_string(task.seed.y) +
                           (task.eight ? " by 8" : " by 4") + ", workspace " + std::to_string(task.capacity);
  oracle::Packed memory = tests::packed_rows<F>(picture.width, picture.height, 1);
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) memory.set(x, y, picture.at(x, y));
  const auto surface = tests::surface_over<F>(memory, picture.width, picture.height);
  const Connectivity connectivity = task.eight ? Connectivity::eight : Connectivity::four;
  auto made = task.border < 0 ? Flood<F>::interior(surface, connectivity, task.seed, task.fill)
                              : Flood<F>::up_to(static_cast<unsigned>(task.border), surface, connectivity,
                                                task.seed, task.fill);
  if (!made.ok()) return what + ": refused";
  Flood<F>& flood = made.value();
  Recorder<F> sink(Solid<F>(surface, task.fill, task.clip), picture.width, picture.height);
  const std::vector<int> expected = region(picture, task);

  std::vector<FloodSpan> workspace(task.capacity);
  bool complete = false;
  for (int calls = 0; !complete; ++calls) {
    const int before = sink.spans();
    const Status status = flood.run(sink, workspace);
    if (sink.bad()) return what + ": a span outside the clip";
    for (std::size_t i = 0; i < expected.size(); ++i)
      if (sink.counts()[i] > expected[i]) return what + ": pixel outside the region or drawn twice";
    complete = status.ok();
    if (complete) break;
    if (status.error() != Error::too_small || status.argument() != Argument::workspace)
      return what + ": wrong status";
    if (status.needed() <= workspace.size()) return what + ": needs no more than it has";
    if (calls > 0 && sink.spans() == before) return what + ": no progress";
    if (!task.grows) {
      const int spans = sink.spans();
      return flood.run(sink, workspace) == status && sink.spans() == spans ? "" : what + ": fickle";
    }
    workspace.resize(status.needed());
    most_entries = std::max(most_entries, workspace.size());
  }
  if (sink.counts() != expected) return what + ": not complete";
  if (flood.pending() != 0) return what + ": complete, but something is pending";
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      const bool filled = expected[static_cast<std::size_t>(y * picture.width + x)] != 0;
      if (memory.get(x, y) != (filled ? task.fill : picture.at(x, y))) return what + ": picture is wrong";
    }
  return "";
}

Plain noise(oracle::Random& random, int width, int height, int kinds) {
  Plain picture(width, height);
  for (unsigned& pixel : picture.pixels) pixel = static_cast<unsigned>(random.between(0, kinds - 1));
  return picture;
}

// Corridors of one pixel between walls of one, every place of them reached by one way only.
Plain maze(oracle::Random& random, int cells_x, int cells_y) {
  Plain picture(2 * cells_x + 1, 2 * cells_y + 1);
  std::fill(picture.pixels.begin(), picture.pixels.end(), 1U);
  std::vector<Point> way{{1, 1}};
  picture.at(1, 1) = 0;
  while (!way.empty()) {
    const Point p = way.back();
    std::vector<Point> steps;
    for (const Point d : {Point{1, 0}, Point{-1, 0}, Point{0, 1}, Point{0, -1}}) {
      const Point q{p.x + 2 * d.x, p.y + 2 * d.y};
      if (q.x > 0 && q.y > 0 && q.x < picture.width && q.y < picture.height && picture.at(q.x, q.y) == 1)
        steps.push_back(d);
    }
    if (steps.empty()) {
      way.pop_back();
      continue;
    }
    const Point d = steps[static_cast<std::size_t>(random.between(0, static_cast<int>(steps.size()) - 1))];
    picture.at(p.x + d.x, p.y + d.y) = 0;
    picture.at(p.x + 2 * d.x, p.y + 2 * d.y) = 0;
    way.push_back({p.x + 2 * d.x, p.y + 2 * d.y});
  }
  return picture;
}

Plain spiral(int size) {
  Plain picture(size, size);
  int x = 0;
  int y = 1;
  int dx = 1;
  int dy = 0;
  // A wall that turns right when the way is barred or one short of a wall.
  const auto wall = [&](int px, int py) {
    return px < 0 || py < 0 || px >= size || py >= size || picture.at(px, py) == 1;
  };
  picture.at(x, y) = 1;
  for (int turns = 0; turns < 2;) {
    if (wall(x + dx, y + dy) || (x + 2 * dx >= 0 && y + 2 * dy >= 0 && x + 2 * dx < size &&
                                 y + 2 * dy < size && wall(x + 2 * dx, y + 2 * dy))) {
      const int old = dx;
      dx = -dy;
      dy = old;
      ++turns;
      continue;
    }
    x += dx;
    y += dy;
    picture.at(x, y) = 1;
    turns = 0;
  }
  return picture;
}

template <class F>
class FloodFormats : public testing::Test {};
TYPED_TEST_SUITE(FloodFormats, tests::AllFormats);

TYPED_TEST(FloodFormats, RandomPicturesAreFilledExactlyWithAnyWorkspace) {
  using F = TypeParam;
  oracle::Random random(2261);
  std::string first_fault;
  for (int i = 0; i < 1500 && first_fault.empty(); ++i) {
    const int kinds = std::min(2 + i % 3, static_cast<int>(F::max_index) + 1);
    Plain picture = noise(random, random.between(1, 21), random.between(1, 17), kinds);
    if (i % 2 == 0)  // mostly one index
      for (unsigned& pixel : picture.pixels)
        if (random.between(0, 2) != 0) pixel = 0;
    Task task;
    task.clip = i % 3 == 0 ? Rect{random.between(-3, 8), random.between(-3, 8), random.between(0, 20),
                                  random.between(0, 20)}
                           : Rect{0, 0, picture.width, picture.height};
    task.eight = random.between(0, 1) != 0;
    task.seed = {random.between(-1, picture.width), random.between(-1, picture.height)};
    task.fill = static_cast<unsigned>(random.between(0, static_cast<int>(F::max_index)));
    if (random.between(0, 1) != 0) task.border = random.between(0, kinds - 1);
    task.capacity = static_cast<std::size_t>(random.between(0, 8));
    task.grows = random.between(0, 3) != 0;
    first_fault = fault<F>(picture, task);
  }
  EXPECT_EQ(first_fault, "") << random.seed_text();
}

TYPED_TEST(FloodFormats, MazesSpiralsCombsAndCheckerboards) {
  using F = TypeParam;
  oracle::Random random(2262);
  Plain comb(41, 23);
  Plain board(31, 27);
  for (int y = 0; y < comb.height; ++y)
    for (int x = 0; x < comb.width; ++x) comb.at(x, y) = x % 2 == 1 && y != comb.height / 2 ? 1 : 0;
  for (int y = 0; y < board.height; ++y)
    for (int x = 0; x < board.width; ++x) board.at(x, y) = static_cast<unsigned>(x + y) % 2;
  Plain rows(23, 41);
  for (int y = 0; y < rows.height; ++y)
    for (int x = 0; x < rows.width; ++x) rows.at(x, y) = comb.at(y, x);
  for (const Plain& picture : {maze(random, 15, 12), maze(random, 4, 30), spiral(33), comb, rows, board})
    for (const bool eight : {false, true})
      for (std::size_t capacity = 0; capacity <= 8; ++capacity)
        for (int i = 0; i < 6; ++i) {
          const Point seed{random.between(0, picture.width - 1), random.between(0, picture.height - 1)};
          Task task{{0, 0, picture.width, picture.height}, eight, seed, 0, -1, capacity};
          task.fill = picture.at(seed.x, seed.y) ^ 1U;
          ASSERT_EQ(fault<F>(picture, task), "") << random.seed_text();
        }
}

TEST(Flood, NeedsAHandfulOfEntriesInMazesAndNoMoreThanARowHasPixelsOnAnEightConnectedBoard) {
  oracle::Random random(2263);
  const auto needed = [](const Plain& picture, bool eight, Point seed) {
    most_entries = 1;
    const Task task{{0, 0, picture.width, picture.height}, eight, seed, 3, -1, 1};
    EXPECT_EQ(fault<image::Indexed8>(picture, task), "");
    return most_entries;
  };
  EXPECT_LE(needed(spiral(101), false, {0, 0}), 2U);
  EXPECT_LE(needed(Plain(200, 150), false, {77, 33}), 2U);
  EXPECT_LE(needed(maze(random, 40, 40), false, {1, 1}), 16U);
  Plain board(64, 64);
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) board.at(x, y) = static_cast<unsigned>(x + y) % 2;
  EXPECT_LE(needed(board, true, {31, 31}), 64U);
}

// The textbook's recursion stops only at the fill's index and runs over a border of another.
TEST(Flood, ABorderOfAnyIndexHoldsTheFillAndALineOfBresenhamHoldsFourNeighbours) {
  Plain picture(40, 30);
  oracle::Packed memory = tests::packed_rows<image::Indexed4>(40, 30);
  const auto surface = tests::surface_over<image::Indexed4>(memory, 40, 30);
  const Solid<image::Indexed4> border(surface, 9);
  ASSERT_TRUE(raster::draw_line(border, {5, 3}, {34, 11}).ok());
  ASSERT_TRUE(raster::draw_line(border, {34, 11}, {20, 27}).ok());
  ASSERT_TRUE(raster::draw_line(border, {20, 27}, {5, 3}).ok());
  surface.set(20, 12, 4);  // a speck of another index inside
  for (int y = 0; y < 30; ++y)
    for (int x = 0; x < 40; ++x) picture.at(x, y) = memory.get(x, y);
  for (const int defined_by : {-1, 9}) {
    Task task{{0, 0, 40, 30}, false, {18, 13}, 2, defined_by, 64};
    EXPECT_EQ(fault<image::Indexed4>(picture, task), "");
    const std::vector<int> inside = region(picture, task);
    EXPECT_EQ(inside[0], 0);  // holds
    EXPECT_EQ(inside[12 * 40 + 20], defined_by < 0 ? 0 : 1);
    task.eight = true;
    EXPECT_EQ(fault<image::Indexed4>(picture, task), "");
    EXPECT_EQ(region(picture, task)[0], 1);  // 8 neighbours leak between the steps of a line
  }
}

TEST(Flood, TheShortFormsFillAndSayWhenTheyCannot) {
  oracle::Packed memory = tests::packed_rows<image::Indexed2>(9, 7);
  const auto surface = tests::surface_over<image::Indexed2>(memory, 9, 7);
  std::vector<FloodSpan> workspace(8);
  EXPECT_TRUE(raster::flood_fill(Solid(surface, 2), Connectivity::four, {4, 3}, workspace).ok());
  for (int i = 0; i < 63; ++i) ASSERT_EQ(memory.get(i % 9, i / 9), 2U);
  EXPECT_TRUE(raster::flood_fill(Solid(surface, 2), Connectivity::four, {4, 3}, workspace).ok());
  EXPECT_TRUE(raster::flood_fill(Solid(surface, 2), Connectivity::four, {4, 3}, {}).ok());
  EXPECT_EQ(raster::flood_fill(Solid(surface, 1), Connectivity::four, {4, 3}, {}),
            (Status{Error::too_small, Argument::workspace, 2}));
  EXPECT_TRUE(raster::boundary_fill(Solid(surface, 1), 3, Connectivity::eight, {0, 0}, workspace).ok());
  for (int i = 0; i < 63; ++i) ASSERT_EQ(memory.get(i % 9, i / 9), 1U);
}

TEST(Flood, BadArgumentsAreNamedAndASeedOutsideFillsNothing) {
  oracle::Packed memory = tests::packed_rows<image::Indexed4>(9, 7);
  const auto surface = tests::surface_over<image::Indexed4>(memory, 9, 7);
  const Solid sink(surface, 5, {2, 2, 4, 4});
  std::vector<FloodSpan> workspace(8);
  for (const int bad : {(1 << 20) + 1, -(1 << 20) - 1, INT_MAX, INT_MIN}) {
    const Status expected{Error::out_of_domain, Argument::point};
    EXPECT_EQ(raster::flood_fill(sink, Connectivity::four, {bad, 3}, workspace), expected);
    EXPECT_EQ(raster::boundary_fill(sink, 1, Connectivity::eight, {3, bad}, workspace), expected);
  }
  EXPECT_EQ(raster::flood_fill(sink, static_cast<Connectivity>(2), {3, 3}, workspace),
            (Status{Error::out_of_range, Argument::rule}));
  for (const unsigned border : {16U, UINT_MAX})
    EXPECT_EQ(raster::boundary_fill(sink, border, Connectivity::four, {3, 3}, workspace),
              (Status{Error::out_of_range, Argument::index}));
  for (const Point outside : {Point{1, 3}, Point{3, 6}, Point{-1, 0}, Point{1 << 20, -(1 << 20)}})
    EXPECT_TRUE(raster::flood_fill(sink, Connectivity::eight, outside, workspace).ok());
  EXPECT_TRUE(Flood<image::Indexed4>().run(sink, workspace).ok());
  for (const std::uint8_t byte : memory.bytes()) ASSERT_EQ(byte, 0);
}

}  // namespace
