// SPDX-License-Identifier: MIT
#include <intaglio/raster/circle.hpp>
#include <intaglio/raster/disc.hpp>
#include <intaglio/raster/ellipse.hpp>
#include <intaglio/raster/solid.hpp>
#include <tests/oracle/counting_sink.hpp>
#include <tests/oracle/oval.hpp>
#include <tests/oracle/random.hpp>
#include <tests/oracle/recording_sink.hpp>
#include <tests/oracle/samples.hpp>
#include <tests/oracle/span_list.hpp>
#include <tests/raster/text.hpp>

#include <climits>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace {

using intaglio::Argument;
using intaglio::Error;
using intaglio::Status;
using intaglio::linear::Point;
using intaglio::linear::Rect;
using intaglio::raster::draw_circle;
using intaglio::raster::draw_circle_in;
using intaglio::raster::draw_ellipse;
using intaglio::raster::fill_disc;
using intaglio::raster::fill_disc_in;
using intaglio::raster::fill_ellipse;
using oracle::RecordingSink;
using oracle::Span;
using oracle::SpanList;
using oracle::Wide;

constexpr int limit = 1 << 20;

std::string text(Point centre, int a, int b, const Rect& clip) {
  return "centre " + tests::text(centre) + " radii " + std::to_string(a) + "," + std::to_string(b) + " in " +
         tests::text(clip);
}

// What is wrong with an ellipse and its outline in this window; empty if nothing is.
std::string fault(Point centre, int a, int b, const Rect& clip) {
  RecordingSink filled(clip);
  RecordingSink outline(clip);
  if (!fill_ellipse(filled, centre, a, b).ok() || !draw_ellipse(outline, centre, a, b).ok())
    return text(centre, a, b, clip) + ": refused";
  if (!filled.violation().empty() || !outline.violation().empty())
    return text(centre, a, b, clip) + ": " + filled.violation() + outline.violation();
  // The oracle's answer for the window and the pixels around it.
  const int stride = clip.width + 2;
  std::vector<char> in;
  for (int y = clip.y - 1; y <= clip.y + clip.height; ++y)
    for (int x = clip.x - 1; x <= clip.x + clip.width; ++x)
      in.push_back(static_cast<char>(oracle::in_oval(2 * a, 2 * b, 2 * (x - centre.x), 2 * (y - centre.y))));
  for (int y = clip.y; y < clip.y + clip.height; ++y)
    for (int x = clip.x; x < clip.x + clip.width; ++x) {
      const char* const at = in.data() + (y - clip.y + 1) * stride + (x - clip.x + 1);
      const bool edge = *at != 0 && (at[-1] == 0 || at[1] == 0 || at[-stride] == 0 || at[stride] == 0);
      if (filled.writes(x, y) != *at || outline.writes(x, y) != (edge ? 1 : 0))
        return text(centre, a, b, clip) + ": pixel " + std::to_string(x) + "," + std::to_string(y) +
               " filled " + std::to_string(filled.writes(x, y)) + " times, outlined " +
               std::to_string(outline.writes(x, y));
    }
  return "";
}

// Every row's reach by the oracle, from the middle outwards. Rows further out never reach further (tested
// below), so the search goes on where it stopped.
std::vector<int> reaches(int a, int b) {
  std::vector<int> result;
  int x = a;
  for (int y = b & 1; y <= b; y += 2) {
    while (!oracle::in_oval(a, b, x, y)) x -= 2;
    result.push_back(x);
  }
  return result;
}

// True if the spans are those of the oval of a+1 by b+1 pixels at (0, 0), rows from the top.
bool is_filled(const std::vector<Span>& spans, int a, int b) {
  const std::vector<int> reach = reaches(a, b);
  if (static_cast<int>(spans.size()) != b + 1) return false;
  for (int y = 0; y <= b; ++y) {
    const int r = reach[static_cast<std::size_t>(std::abs(2 * y - b) / 2)];
    if (spans[static_cast<std::size_t>(y)] != Span{y, (a - r) / 2, (a + r) / 2 + 1}) return false;
  }
  return true;
}

TEST(OvalOracle, IsSymmetricConvexTransposableAndNearestAlongTheMinorDirection) {
  std::string first_fault;
  const auto check = [&](bool good, int a, int b, int x, int y, const char* what) {
    if (!good && first_fault.empty()) first_fault = text({x, y}, a, b, {}) + ": " + what;
  };
  for (int a = 0; a <= 36; ++a)
    for (int b = 0; b <= 36; ++b) {
      if ((a - b) % 2 != 0) continue;
      check(oracle::in_oval(a, b, a, b % 2) && oracle::in_oval(a, b, a % 2, b), a, b, a, b,
            "box not reached");
      for (int y = -b; y <= b; y += 2)
        for (int x = -a; x <= a; x += 2) {
          const bool in = oracle::in_oval(a, b, x, y);
          check(in == oracle::in_oval(a, b, -x, y) && in == oracle::in_oval(a, b, x, -y), a, b, x, y,
                "mirror");
          check(in == oracle::in_oval(b, a, y, x), a, b, x, y, "transposed");
          if (in && x >= 2) check(oracle::in_oval(a, b, x - 2, y), a, b, x, y, "dent in a row");
          if (in && y >= 2) check(oracle::in_oval(a, b, x, y - 2), a, b, x, y, "dent in a column");
          if (!oracle::on_oval(a, b, x, y) || a == 0 || b == 0) continue;
          // b*sqrt(a^2 - x^2)/a is within 1 (half a pixel) of |y|, or the same along x.
          const auto near = [](Wide p, Wide q, Wide at_p, Wide at_q) {
            const Wide root = q * q * (p * p - at_p * at_p);  // (p * exact |at_q|)^2
            const Wide low = at_q < 1 ? 0 : at_q - 1;
            return low * low * p * p <= root && root <= (at_q + 1) * (at_q + 1) * p * p;
          };
          check(near(a, b, std::abs(x), std::abs(y)) || near(b, a, std::abs(y), std::abs(x)), a, b, x, y,
                "further than half a pixel");
        }
    }
  EXPECT_EQ(first_fault, "");
}

TEST(Oval, BoxesOfUnequalEvenSidesAreFilledExactly) {
  using intaglio::raster::RowSpan;
  using intaglio::raster::detail::Oval;
  int wrong = 0;
  for (int width = 2; width <= 60; width += 2)
    for (int height = 2; height <= 60; height += 2) {
      Oval oval({5, -7}, width, height);
      for (int y = 0; y < height; ++y) {
        const RowSpan row = oval.row(y - 7);
        const int reach = oracle::oval_reach(width - 1, height - 1, 2 * y - (height - 1));
        wrong += row != RowSpan{y - 7, 5 + (width - 1 - reach) / 2, 5 + (width - 1 + reach) / 2 + 1} ? 1 : 0;
      }
    }
  EXPECT_EQ(wrong, 0);
  oracle::Random random(92);
  for (int i = 0; i < 2000; ++i) {
    const int a = 2 * random.between(0, (1 << 20 >> i % 20) - 1) + 1;
    const int b = 2 * random.between(0, (1 << 20 >> i % 17) - 1) + 1;
    Oval oval({0, 0}, a + 1, b + 1);
    const int y = random.between(0, b);
    const RowSpan row = oval.row(y);
    const int reach = 2 * row.x_end - 2 - a;
    wrong += row.x_begin + row.x_end != a + 1 || !oracle::in_oval(a, b, reach, 2 * y - b) ||
                     oracle::in_oval(a, b, reach + 2, 2 * y - b)
                 ? 1
                 : 0;
  }
  EXPECT_EQ(wrong, 0) << random.seed_text();
}

TEST(Ellipse, AllRadiiTo200AreFilledExactlyWithOneSpanARow) {
  SpanList list;
  for (int a = 0; a <= 200; ++a)
    for (int b = 0; b <= 200; ++b) {
      list.clear();
      ASSERT_TRUE(fill_ellipse(list, {a, b}, a, b).ok());
      ASSERT_TRUE(is_filled(list.sorted(), 2 * a, 2 * b)) << a << "," << b;
    }
}

TEST(Ellipse, AllOutlinesTo200AreTheFilledRowsWithoutWhatTheirNeighboursHide) {
  SpanList list;
  for (int a = 0; a <= 200; ++a)
    for (int b = 0; b <= 200; ++b) {
      list.clear();
      ASSERT_TRUE(draw_ellipse(list, {0, 0}, a, b).ok());
      const std::vector<int> reach = reaches(2 * a, 2 * b);
      std::vector<Span> expected;
      for (int y = -b; y <= b; ++y) {
        const auto row = static_cast<std::size_t>(std::abs(y));
        const int outer = reach[row] / 2;
        const int inner = std::min(outer - 1, row + 1 < reach.size() ? reach[row + 1] / 2 : -1);
        if (inner < 0) {
          expected.push_back({y, -outer, outer + 1});
        } else {
          expected.push_back({y, -outer, -inner});
          expected.push_back({y, inner + 1, outer + 1});
        }
      }
      ASSERT_TRUE(list.spans() == expected) << a << "," << b;
    }
}

TEST(Ellipse, SmallOnesAreExactPixelByPixelInEveryWindow) {
  std::string first_fault;
  for (int a = 0; a <= 12; ++a)
    for (int b = 0; b <= 12 && first_fault.empty(); ++b)
      for (int y = -14; y <= 14; y += 3)
        for (int x = -14; x <= 14; x += 3)
          for (const Rect clip : {Rect{x, y, 1, 1}, Rect{x, y, 3, 5}, Rect{x, y, 29, 2}, Rect{x, y, 29, 29}})
            if (first_fault.empty()) first_fault = fault({0, 0}, a, b, clip);
  EXPECT_EQ(first_fault, "");
}

TEST(Ellipse, RandomOnesInWindowsNearTheirOutlineAreExactToTheDomainsEdge) {
  oracle::Random random(31);
  std::string first_fault;
  int outline_pixels = 0;
  for (int i = 0; i < oracle::samples(4000, 100000) && first_fault.empty(); ++i) {
    const int a = random.between(0, limit >> random.between(0, 19));
    const int b = i % 4 == 0 ? a : random.between(0, limit >> random.between(0, 19));
    const Point centre{random.between(-limit, limit), random.between(-limit, limit)};
    // A pixel of the outline on some row, perhaps near an axis; found by halving, as the rows are convex.
    int dy = random.between(0, b);
    if (i % 3 == 1) dy = std::min(b, random.between(0, 30));
    if (i % 3 == 2) dy = std::max(0, b - random.between(0, 30));
    int dx = 0;
    for (int step = limit; step > 0; step /= 2)
      if (oracle::in_oval(2 * a, 2 * b, 2 * (dx + step), 2 * dy)) dx += step;
    const int sign = random.between(0, 1) * 2 - 1;
    const Rect clip{centre.x + sign * dx - random.between(0, 40),
                    centre.y - sign * dy - random.between(0, 40), random.between(1, 60),
                    random.between(1, 60)};
    if (!intaglio::linear::in_domain(clip)) continue;
    first_fault = fault(centre, a, b, clip);
    oracle::CountingSink count(clip);
    ASSERT_TRUE(draw_ellipse(count, centre, a, b).ok());
    outline_pixels += count.pixels() > 0 ? 1 : 0;
  }
  EXPECT_EQ(first_fault, "") << random.seed_text();
  EXPECT_GT(outline_pixels, 500);
}

TEST(Ellipse, LargestRadiiAreExactAtTheirTips) {
  std::string first_fault;
  for (const int a : {limit, limit - 1, 65536, 46341, 645, 1, 0})
    for (const int b : {limit, limit - 1, 65535, 1, 0})
      for (const Point at : {Point{0, -b}, {0, b}, {a, 0}, {-a, 0}}) {
        const Rect clip{at.x - 40, at.y - 40, 80, 80};
        if (first_fault.empty() && intaglio::linear::in_domain(clip)) first_fault = fault({0, 0}, a, b, clip);
      }
  EXPECT_EQ(first_fault, "");
}

TEST(Ellipse, EqualRadiiAreTheCircleAndTheDisc) {
  const Rect box{-64, -64, 129, 129};
  for (int r = 0; r <= 70; ++r) {
    RecordingSink ellipse(box);
    RecordingSink circle(box);
    ASSERT_TRUE(draw_ellipse(ellipse, {1, -2}, r, r).ok());
    ASSERT_TRUE(draw_circle(circle, {1, -2}, r).ok());
    ASSERT_EQ(ellipse.all_writes(), circle.all_writes()) << r;
    ASSERT_TRUE(fill_ellipse(ellipse, {1, -2}, r, r).ok());
    ASSERT_TRUE(fill_disc(circle, {1, -2}, r).ok());
    ASSERT_EQ(ellipse.all_writes(), circle.all_writes()) << r;
  }
}

TEST(DiametricCircle, EveryDiameterTo1000IsExactAndOddOnesAreTheDiscsOfThatRadius) {
  SpanList list;
  SpanList disc;
  for (int d = 1; d <= 1000; ++d) {
    list.clear();
    ASSERT_TRUE(fill_disc_in(list, {0, 0}, d).ok());
    ASSERT_TRUE(is_filled(list.sorted(), d - 1, d - 1)) << "diameter " << d;
    if (d % 2 == 0) continue;
    disc.clear();
    ASSERT_TRUE(fill_disc(disc, {d / 2, d / 2}, d / 2).ok());
    ASSERT_TRUE(list.sorted() == disc.sorted()) << "diameter " << d;
  }
}

TEST(DiametricCircle, OutlinesAreExactPixelByPixelAndUnchangedByQuarterTurns) {
  for (int d = 1; d <= 70; ++d) {
    RecordingSink sink({-1, -1, 72, 72});
    RecordingSink filled({-1, -1, 72, 72});
    ASSERT_TRUE(draw_circle_in(sink, {0, 0}, d).ok());
    ASSERT_TRUE(fill_disc_in(filled, {0, 0}, d).ok());
    ASSERT_EQ(sink.violation() + filled.violation(), "");
    for (int y = -1; y < 71; ++y)
      for (int x = -1; x < 71; ++x) {
        const int a = d - 1;
        ASSERT_EQ(sink.writes(x, y), oracle::on_oval(a, a, 2 * x - a, 2 * y - a) ? 1 : 0)
            << d << " " << x << "," << y;
        ASSERT_EQ(filled.writes(x, y), oracle::in_oval(a, a, 2 * x - a, 2 * y - a) ? 1 : 0)
            << d << " " << x << "," << y;
        ASSERT_EQ(sink.writes(x, y), sink.writes(d - 1 - y, x)) << d;
      }
  }
}

TEST(DiametricCircle, SmallEvenOnesLookRight) {
  const auto picture = [](int d) {
    RecordingSink sink({0, 0, d, d});
    EXPECT_TRUE(draw_circle_in(sink, {0, 0}, d).ok());
    return sink.ascii();
  };
  EXPECT_EQ(picture(2), "##\n##\n");
  EXPECT_EQ(picture(4), ".##.\n#..#\n#..#\n.##.\n");
  // Diameter 6: the pixel one and a half columns from the middle is exactly halfway, and the outer one is
  // taken.
  EXPECT_EQ(picture(6), ".####.\n#....#\n#....#\n#....#\n#....#\n.####.\n");
}

TEST(DiametricCircle, LargestDiametersAreExactInWindows) {
  oracle::Random random(32);
  for (int i = 0; i < 400; ++i) {
    const int d = 2 * limit - random.between(0, 3);
    const Point corner{-limit, -limit + random.between(0, 5)};
    const int a = d - 1;
    const int y0 = random.between(0, d - 1);
    int inset = 0;  // pixels of the row that aren't in the disc
    for (int step = limit; step > 0; step /= 2)
      if (inset + step <= a / 2 && !oracle::in_oval(a, a, 2 * (inset + step - 1) - a, 2 * y0 - a))
        inset += step;
    const Rect clip{corner.x + std::max(0, inset - 20), std::min(corner.y + y0, limit - 9), 40, 8};
    RecordingSink outline(clip);
    RecordingSink filled(clip);
    ASSERT_TRUE(draw_circle_in(outline, corner, d).ok());
    ASSERT_TRUE(fill_disc_in(filled, corner, d).ok());
    for (int y = clip.y; y < clip.y + 8; ++y)
      for (int x = clip.x; x < clip.x + 40; ++x) {
        const int dx = 2 * (x - corner.x) - a;
        const int dy = 2 * (y - corner.y) - a;
        ASSERT_EQ(outline.writes(x, y), oracle::on_oval(a, a, dx, dy) ? 1 : 0)
            << random.seed_text() << " " << i;
        ASSERT_EQ(filled.writes(x, y), oracle::in_oval(a, a, dx, dy) ? 1 : 0)
            << random.seed_text() << " " << i;
      }
  }
}

TEST(Ellipse, WorkIsBoundedByTheVisibleRows) {
  // Ellipses two million pixels wide or high: milliseconds if only the window is visited.
  long spans = 0;
  for (int i = 0; i < 1000; ++i) {
    oracle::CountingSink sink({0, 0, 320, 240});
    ASSERT_TRUE(draw_ellipse(sink, {160, limit - i}, 900 * i, limit - i - 100).ok());
    ASSERT_TRUE(fill_ellipse(sink, {i + 160 - limit, 120}, limit - i, 700 + i).ok());
    ASSERT_TRUE(fill_disc_in(sink, {-limit, -limit / 2}, 2 * limit).ok());
    spans += static_cast<long>(sink.spans());
  }
  EXPECT_GT(spans, 1000L * 240);
}

TEST(Ellipse, ExclusiveOrTwiceRestoresOnEveryDepth) {
  const auto restores = [](auto format) {
    using F = decltype(format);
    std::vector<std::uint8_t> pixels(static_cast<std::size_t>(F::row_bytes(61)) * 41U);
    const auto surface = intaglio::image::Surface<F>::over(pixels, {61, 41}).value();
    const intaglio::raster::Xor ink(surface, 1U);
    for (int pass = 0; pass < 2; ++pass) {
      for (int a = 0; a < 40; a += 3)
        if (!draw_ellipse(ink, {30, 20}, a, 25 - a / 2).ok() || !fill_ellipse(ink, {9, 7}, a, a / 3).ok() ||
            !draw_circle_in(ink, {-3, -4}, a + 1).ok())
          return false;
      if (pass == 0 && std::all_of(pixels.begin(), pixels.end(), [](auto p) { return p == 0; })) return false;
    }
    return std::all_of(pixels.begin(), pixels.end(), [](auto p) { return p == 0; });
  };
  EXPECT_TRUE(restores(intaglio::image::Indexed8{}));
  EXPECT_TRUE(restores(intaglio::image::Indexed4Lsb{}));
  EXPECT_TRUE(restores(intaglio::image::Indexed2{}));
  EXPECT_TRUE(restores(intaglio::image::Indexed1{}));
}

TEST(Ellipse, BadArgumentsAreNamedAndNothingIsDrawn) {
  RecordingSink sink({0, 0, 8, 8});
  const Status bad_radius{Error::out_of_domain, Argument::radius};
  const Status bad_point{Error::out_of_domain, Argument::point};
  const Status bad_size{Error::out_of_domain, Argument::size};
  for (const int r : {-1, INT_MIN, limit + 1, INT_MAX}) {
    EXPECT_EQ(draw_ellipse(sink, {4, 4}, r, 3), bad_radius);
    EXPECT_EQ(draw_ellipse(sink, {4, 4}, 3, r), bad_radius);
    EXPECT_EQ(fill_ellipse(sink, {4, 4}, r, r), bad_radius);
  }
  for (const int d : {-1, INT_MIN, 2 * limit + 1, INT_MAX}) {
    EXPECT_EQ(draw_circle_in(sink, {4, 4}, d), bad_size);
    EXPECT_EQ(fill_disc_in(sink, {4, 4}, d), bad_size);
  }
  for (const Point p : {Point{limit + 1, 0}, {0, -limit - 1}, {INT_MIN, 0}, {0, INT_MAX}}) {
    EXPECT_EQ(draw_ellipse(sink, p, 3, 4), bad_point);
    EXPECT_EQ(fill_ellipse(sink, p, 3, 4), bad_point);
    EXPECT_EQ(draw_circle_in(sink, p, 3), bad_point);
    EXPECT_EQ(fill_disc_in(sink, p, 3), bad_point);
  }
  EXPECT_TRUE(draw_circle_in(sink, {4, 4}, 0).ok());
  EXPECT_TRUE(fill_disc_in(sink, {4, 4}, 0).ok());
  EXPECT_EQ(sink.spans(), 0);
  RecordingSink nothing({3, 3, 0, 0});
  EXPECT_TRUE(draw_ellipse(nothing, {3, 3}, 0, 5).ok());
  EXPECT_TRUE(fill_ellipse(nothing, {3, 3}, 10, 4).ok());
  EXPECT_EQ(nothing.spans(), 0);
}

}  // namespace
