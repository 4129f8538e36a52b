// SPDX-License-Identifier: MIT
//
// Other libraries beside ours: the same pictures, in one run.
//
// Rule: each picture is drawn by each painter into memory it owns, over and over; the time is that of the
// shapes alone, without clearing. Before, each shape is drawn by itself on black and compared with the oracle
// pixel by pixel: a pixel counts as drawn from half of white up, so smoothed pictures are held to the same
// question. `wrong` is the sum over all shapes of pixels drawn that shouldn't be and of those missing, so a
// pixel in the wrong place counts twice; `pixels` is how many the shapes have. Smoothed pictures of triangles
// are also held against the exact area: `level_off` is the largest difference in 1/255, at best half of one.
//
// Output is Google Benchmark's, with these counters; a name is `picture/painter`. tests/bench/run makes the
// table of README.md from it.
#include <tests/bench/painter.hpp>
#include <tests/oracle/coverage.hpp>

#include <algorithm>
#include <benchmark/benchmark.h>
#include <cmath>
#include <cstddef>
#include <utility>

namespace bench {
namespace {

struct Error {
  long wrong = 0;
  long pixels = 0;
  double level_off = -1;  // -1: not asked
};

/// A picture, and pixel by pixel what its shapes have.
struct Expectation {
  static constexpr std::size_t areas_of = 12;

  explicit Expectation(Picture p) : picture(std::move(p)) {
    for (const Shape& shape : picture.shapes) {
      std::vector<bool>& pixels = has.emplace_back();
      pixels.reserve(std::size_t{width} * height);
      for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) pixels.push_back(has_pixel(shape, x, y));
      const auto* const polygon = std::get_if<Polygon>(&shape);
      if (polygon == nullptr || polygon->vertices.size() != 3 || levels.size() == areas_of) continue;
      std::vector<double>& level = levels.emplace_back();
      for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) level.push_back(exact_level(*polygon, x, y));
    }
  }

  Picture picture;
  std::vector<std::vector<bool>> has;
  std::vector<std::vector<double>> levels;  // of the first shapes, in 1/255

 private:
  static double exact_level(const Polygon& polygon, int x, int y) {
    const auto inside = [&](auto coordinate, int centre) {
      int low = 1 << 30;
      int high = -low;
      for (const auto& v : polygon.vertices)
        low = std::min(low, v.*coordinate), high = std::max(high, v.*coordinate);
      return low < centre * 256 + 128 && high > centre * 256 - 128;
    };
    using intaglio::linear::SubPoint;
    if (!inside(&SubPoint::x, x) || !inside(&SubPoint::y, y)) return 0;
    const mpq_class area = oracle::coverage({polygon.vertices}, polygon.even_odd, x, y) * 255;
    return area.get_d();
  }
};

/// What a painter draws against what it should; false if it can't draw one of the shapes.
bool measure(Painter& painter, const Expectation& expected, bool smooth, Error& error) {
  for (std::size_t i = 0; i < expected.picture.shapes.size(); ++i) {
    painter.clear();
    if (!painter.draw(expected.picture.shapes[i])) return false;
    painter.finish();
    const bool by_level = smooth && i < expected.levels.size();
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        const auto at = static_cast<std::size_t>(y * width + x);
        const bool has = expected.has[i][at];
        const int level = painter.level(x, y);
        error.pixels += has ? 1 : 0;
        error.wrong += has != (level >= 128) ? 1 : 0;
        if (by_level) error.level_off = std::max(error.level_off, std::fabs(level - expected.levels[i][at]));
      }
  }
  return true;
}

void run(benchmark::State& state, Painter& painter, const Picture& picture, const Error& error) {
  painter.clear();
  for ([[maybe_unused]] auto _ : state) {
    for (const Shape& shape : picture.shapes) painter.draw(shape);
    painter.finish();
    benchmark::ClobberMemory();
  }
  state.counters["wrong"] = static_cast<double>(error.wrong);
  state.counters["pixels"] = static_cast<double>(error.pixels);
  if (error.level_off >= 0) state.counters["level_off"] = error.level_off;
}

struct Contestant {
  std::string name;
  std::unique_ptr<Painter> painter;
  bool smooth;
};

}  // namespace
}  // namespace bench

int main(int argc, char** argv) {
  using namespace bench;
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  std::vector<Contestant> contestants;
  contestants.push_back({"intaglio", make_intaglio(), false});
  contestants.push_back({"cairo", make_cairo(false), false});
  contestants.push_back({"AGG", make_agg(false), false});
  contestants.push_back({"SDL2_gfx", make_sdl_gfx(), false});
  contestants.push_back({"intaglio smooth", make_intaglio_smooth(), true});
  contestants.push_back({"cairo smooth", make_cairo(true), true});
  contestants.push_back({"AGG smooth", make_agg(true), true});
  std::vector<Expectation> expectations;
  for (Picture& picture : pictures()) expectations.emplace_back(std::move(picture));
  for (const Expectation& expected : expectations)
    for (const Contestant& contestant : contestants) {
      Error error;
      Painter& painter = *contestant.painter;
      if (!measure(painter, expected, contestant.smooth, error)) continue;
      const std::string name = expected.picture.name + "/" + contestant.name;
      benchmark::RegisterBenchmark(name.c_str(), [&painter, &expected, error](benchmark::State& state) {
        run(state, painter, expected.picture, error);
      });
    }
  benchmark::RunSpecifiedBenchmarks();
}
