// SPDX-License-Identifier: MIT
#include <intaglio/raster/arc.hpp>
#include <intaglio/raster/ellipse_arc.hpp>
#include <tests/oracle/oval.hpp>
#include <tests/oracle/random.hpp>
#include <tests/oracle/recording_sink.hpp>
#include <tests/oracle/samples.hpp>
#include <tests/oracle/sector.hpp>

#include <climits>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

namespace {

using intaglio::Argument;
using intaglio::Error;
using intaglio::Status;
using intaglio::linear::Point;
using intaglio::linear::Rect;
using intaglio::number::Angle;
using intaglio::raster::draw_ellipse_arc;
using intaglio::raster::fill_ellipse_chord;
using intaglio::raster::fill_ellipse_pie;
using oracle::RecordingSink;

constexpr int limit = 1 << 20;

Angle steps(int n) { return Angle::from_steps(n); }

struct Part {
  Point centre;
  int a;
  int b;
  int start;
  int sweep;

  [[nodiscard]] std::string text() const {
    return "centre " + std::to_string(centre.x) + "," + std::to_string(centre.y) + " radii " +
           std::to_string(a) + "," + std::to_string(b) + " start " + std::to_string(start) + " sweep " +
           std::to_string(sweep) + ": ";
  }
};

// Where the ray at an angle meets the ellipse, in extended floating point.
struct Place {
  long double x;
  long double y;
};
Place end_of(int a, int b, int angle) {
  const long double turn = 6.283185307179586476925286766559L * static_cast<long double>(angle) / 65536;
  // Exactly 0 on the axes, as the directions are.
  const long double cosine = std::abs(angle % 32768) == 16384 ? 0 : std::cos(turn);
  const long double sine = angle % 32768 == 0 ? 0 : std::sin(turn);
  const long double across = std::hypot(b * cosine, a * sine);
  if (across == 0) return {cosine * a, sine * b};
  return {static_cast<long double>(a) * b * cosine / across, static_cast<long double>(a) * b * sine / across};
}

// True if which of two pixels is nearest depends on more than the 1/256 pixel that ends are known to.
bool open(const Place& place) {
  const auto halfway = [](long double v) {
    return std::abs(std::abs(v - std::round(v)) - 0.5L) <= 1.0L / 256;
  };
  return halfway(place.x) || halfway(place.y);
}

bool in_chord(const Part& part, int x, int y) {
  if (part.sweep >= 65536 || part.sweep <= -65536) return true;
  const auto pixel = [&](int angle) {
    const Place place = end_of(part.a, part.b, angle);
    return Point{static_cast<int>(std::lround(place.x)), static_cast<int>(std::lround(place.y))};
  };
  const Point from = pixel(part.sweep < 0 ? part.start + part.sweep : part.start);
  const Point to = pixel(part.sweep < 0 ? part.start : part.start + part.sweep);
  if (from == to)
    return std::abs(part.sweep) == 32768 ? oracle::in_sweep(0, 0, part.start, part.sweep)
                                         : std::abs(part.sweep) > 32768;
  const oracle::Wide side =
      oracle::Wide{from.x - to.x} * (y - to.y) - oracle::Wide{from.y - to.y} * (x - to.x);
  if (side != 0) return side > 0;
  return to.y > from.y || (to.y == from.y && to.x < from.x);
}

// What is wrong in this window; empty if nothing is.
std::string fault(const Part& part, const Rect& clip, bool with_chord) {
  RecordingSink arc(clip);
  RecordingSink pie(clip);
  RecordingSink chord(clip);
  const Angle start = steps(part.start);
  if (!draw_ellipse_arc(arc, part.centre, part.a, part.b, start, part.sweep).ok() ||
      !fill_ellipse_pie(pie, part.centre, part.a, part.b, start, part.sweep).ok() ||
      !fill_ellipse_chord(chord, part.centre, part.a, part.b, start, part.sweep).ok())
    return part.text() + "refused";
  const std::string violation = arc.violation() + pie.violation() + chord.violation();
  if (!violation.empty()) return part.text() + violation;
  for (int y = clip.y; y < clip.y + clip.height; ++y)
    for (int x = clip.x; x < clip.x + clip.width; ++x) {
      const int dx = x - part.centre.x;
      const int dy = y - part.centre.y;
      const bool in = oracle::in_oval(2 * part.a, 2 * part.b, 2 * dx, 2 * dy);
      const bool on = in && oracle::on_oval(2 * part.a, 2 * part.b, 2 * dx, 2 * dy);
      const bool swept = in && oracle::in_sweep(dx, dy, part.start, part.sweep);
      const bool cut = in && part.sweep != 0 && with_chord && in_chord(part, dx, dy);
      if (arc.writes(x, y) != (on && swept ? 1 : 0) || pie.writes(x, y) != (swept ? 1 : 0) ||
          (with_chord && chord.writes(x, y) != (cut ? 1 : 0)))
        return part.text() + "pixel " + std::to_string(x) + "," + std::to_string(y);
    }
  return "";
}

bool ends_are_clear(const Part& part) {
  return !open(end_of(part.a, part.b, part.start)) && !open(end_of(part.a, part.b, part.start + part.sweep));
}

TEST(EllipseArc, SmallOnesAreExactForManyAnglesBothWays) {
  std::string first_fault;
  for (const int a : {0, 1, 2, 3, 8})
    for (const int b : {0, 1, 2, 5, 7})
      for (int start = 0; start < 65536; start += 4096)
        for (int sweep = -66560; sweep <= 66560 && first_fault.empty(); sweep += 5120) {
          const Part part{{0, 0}, a, b, start, sweep};
          first_fault = fault(part, {-9, -9, 19, 19}, ends_are_clear(part));
        }
  EXPECT_EQ(first_fault, "");
}

TEST(EllipseArc, RandomOnesInWindowsAreExactToTheDomainsEdge) {
  oracle::Random random(41);
  std::string first_fault;
  const int parts = oracle::samples(600, 40000);
  int chords = 0;
  for (int i = 0; i < parts && first_fault.empty(); ++i) {
    const int a = random.between(0, limit >> random.between(0, 20));
    const int b = random.between(0, limit >> random.between(0, 20));
    Part part{{0, 0}, a, b, random.between(0, 65535), random.between(-65536, 65536)};
    // Near an end of the arc or the middle of the chord.
    const Place first = end_of(a, b, part.start);
    const Place last = end_of(a, b, part.start + part.sweep);
    const long double way = i % 3 == 0 ? 0 : i % 3 == 1 ? 1 : 0.5L;
    part.centre = {-static_cast<int>(first.x + way * (last.x - first.x)),
                   -static_cast<int>(first.y + way * (last.y - first.y))};
    const Rect clip{random.between(-50, 5), random.between(-50, 5), random.between(1, 60),
                    random.between(1, 60)};
    const bool with_chord = ends_are_clear(part);
    chords += with_chord ? 1 : 0;
    first_fault = fault(part, clip, with_chord);
  }
  EXPECT_EQ(first_fault, "") << random.seed_text();
  EXPECT_GT(chords, parts * 8 / 10);
}

TEST(EllipseArc, ChordsEndAtPixelsNearTheArcsEndsForEveryAngle) {
  long double worst = 0;
  const int radii[] = {0, 1, 2, 7, 100, 4099, 741455, limit};
  for (const int a : radii)
    for (const int b : radii)
      for (int angle = 0; angle < 65536; angle += oracle::samples(37, 1)) {
        const Point pixel = intaglio::raster::detail::Ray(steps(angle)).on_ellipse(a, b);
        const Place place = end_of(a, b, angle);
        worst = std::max({worst, std::abs(static_cast<long double>(pixel.x) - place.x),
                          std::abs(static_cast<long double>(pixel.y) - place.y)});
      }
  EXPECT_LE(worst, 0.5L + 1.0L / 256);
}

TEST(EllipseArc, EqualHalfAxesGiveThePartsOfTheCircle) {
  oracle::Random random(42);
  for (int i = 0; i < 300; ++i) {
    const int r = random.between(0, 60);
    const int start = random.between(0, 65535);
    const int sweep = random.between(-65536, 65536);
    RecordingSink round({-62, -62, 125, 125});
    RecordingSink oval({-62, -62, 125, 125});
    ASSERT_TRUE(intaglio::raster::draw_arc(round, {0, 0}, r, steps(start), sweep).ok());
    ASSERT_TRUE(draw_ellipse_arc(oval, {0, 0}, r, r, steps(start), sweep).ok());
    ASSERT_EQ(oval.ascii(), round.ascii()) << r << " " << start << " " << sweep;
    RecordingSink round_cut({-62, -62, 125, 125});
    RecordingSink oval_cut({-62, -62, 125, 125});
    ASSERT_TRUE(intaglio::raster::fill_chord(round_cut, {0, 0}, r, steps(start), sweep).ok());
    ASSERT_TRUE(fill_ellipse_chord(oval_cut, {0, 0}, r, r, steps(start), sweep).ok());
    ASSERT_EQ(oval_cut.ascii(), round_cut.ascii()) << r << " " << start << " " << sweep;
  }
}

TEST(EllipseArc, AnyCutsMakeTheWholeEllipseEachPixelOnce) {
  oracle::Random random(43);
  for (int i = 0; i < 200; ++i) {
    const int a = random.between(0, 40);
    const int b = random.between(0, 40);
    std::vector<int> cuts{random.between(0, 65535), random.between(0, 65535), random.between(0, 65535)};
    if (i % 2 == 0) cuts = {0, 16384, 32768, 49152};
    std::sort(cuts.begin(), cuts.end());
    cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
    RecordingSink arcs({-42, -42, 85, 85});
    RecordingSink pies({-42, -42, 85, 85});
    RecordingSink chords({-42, -42, 85, 85});
    for (std::size_t c = 0; c < cuts.size(); ++c) {
      const int next = c + 1 < cuts.size() ? cuts[c + 1] : cuts[0] + 65536;
      const bool back = random.between(0, 1) != 0;
      const Angle start = steps(back ? next : cuts[c]);
      const int sweep = back ? cuts[c] - next : next - cuts[c];
      ASSERT_TRUE(draw_ellipse_arc(arcs, {0, 0}, a, b, start, sweep).ok());
      ASSERT_TRUE(fill_ellipse_pie(pies, {0, 0}, a, b, start, sweep).ok());
    }
    const int sweep = i % 4 == 0 ? 32768 : random.between(1, 65535);
    ASSERT_TRUE(fill_ellipse_chord(chords, {0, 0}, a, b, steps(cuts[0]), sweep).ok());
    ASSERT_TRUE(fill_ellipse_chord(chords, {0, 0}, a, b, steps(cuts[0]), sweep - 65536).ok());
    for (int y = -42; y < 43; ++y)
      for (int x = -42; x < 43; ++x) {
        const int in = oracle::in_oval(2 * a, 2 * b, 2 * x, 2 * y) ? 1 : 0;
        const int on = in != 0 && oracle::on_oval(2 * a, 2 * b, 2 * x, 2 * y) ? 1 : 0;
        ASSERT_EQ(arcs.writes(x, y), on) << a << "," << b << " at " << x << "," << y;
        ASSERT_EQ(pies.writes(x, y), in) << a << "," << b << " at " << x << "," << y;
        ASSERT_EQ(chords.writes(x, y), in) << a << "," << b << " at " << x << "," << y;
      }
  }
}

TEST(EllipseArc, AFullTurnOrMoreIsTheEllipseAndNoTurnIsNothing) {
  for (const int sweep : {0, 65536, 65537, INT_MAX, -65536, -65537, INT_MIN})
    EXPECT_EQ(fault({{0, 0}, 9, 4, 12345, sweep}, {-10, -10, 21, 21}, true), "") << sweep;
}

TEST(EllipseArc, BadArgumentsAreNamedAndNothingIsDrawn) {
  RecordingSink sink({0, 0, 8, 8});
  const Status radius{Error::out_of_domain, Argument::radius};
  const Status point{Error::out_of_domain, Argument::point};
  for (const int r : {-1, INT_MIN, limit + 1, INT_MAX})
    for (const int sweep : {0, 5, INT_MAX}) {
      EXPECT_EQ(draw_ellipse_arc(sink, {4, 4}, r, 3, {}, sweep), radius);
      EXPECT_EQ(fill_ellipse_pie(sink, {4, 4}, 3, r, {}, sweep), radius);
      EXPECT_EQ(fill_ellipse_chord(sink, {4, 4}, r, r, {}, sweep), radius);
    }
  EXPECT_EQ(draw_ellipse_arc(sink, {INT_MIN, 4}, 3, 3, {}, 5), point);
  EXPECT_EQ(fill_ellipse_pie(sink, {4, INT_MAX}, 3, 3, {}, 5), point);
  EXPECT_EQ(fill_ellipse_chord(sink, {INT_MAX, 4}, 3, 3, {}, 5), point);
  EXPECT_EQ(sink.spans(), 0);
}

}  // namespace
