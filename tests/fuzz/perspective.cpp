// SPDX-License-Identifier: MIT
//
// Values along runs seen in perspective: every rung within its bound, wherever the walk begins.
#include <intaglio/raster/perspective.hpp>
#include <tests/fuzz/input.hpp>
#include <tests/oracle/perspective.hpp>

#include <vector>

namespace fuzz {
namespace {

using namespace intaglio::raster;

template <class Rung>
void check_rung(const Perspective& run, const std::vector<int>& exact, int begin) {
  const int bound = Rung::bound(run);
  std::vector<int> values;
  walk_perspective<Rung>(run, 0, run.steps() + 1, [&](int value) { values.push_back(value); });
  require(values.size() == exact.size(), "walk_perspective: not one value a pixel");
  for (std::size_t i = 0; i < values.size(); ++i)
    require(std::abs(values[i] - exact[i]) <= bound, "walk_perspective: further off than the bound");
  int k = begin;
  walk_perspective<Rung>(run, begin, run.steps() + 1, [&](int value) {
    require(value == values[static_cast<std::size_t>(k++)], "walk_perspective: another value under a clip");
  });
}

}  // namespace

void run(Input in) {
  const auto value = [&] {
    const int kind = in.byte();
    if (kind < 0x80) return kind * 256 + in.byte();
    if (kind < 0xF0) return in.any() % (perspective_value_limit + 1);
    return in.edge(perspective_value_limit);
  };
  const auto depth = [&] {
    const int kind = in.byte();
    if (kind < 0xC0) return static_cast<std::uint32_t>(kind);
    return kind < 0xF0 ? static_cast<std::uint32_t>(in.any()) >> (kind & 31)
                       : static_cast<std::uint32_t>(in.any());
  };
  const int from = value();
  const int to = value();
  const std::uint32_t from_depth = depth();
  const std::uint32_t to_depth = depth();
  const int steps = in.byte() < 0xF0 ? in.byte() : in.any();
  const auto made = Perspective::by_depths(from, to, from_depth, to_depth, steps);
  if (!made.ok()) return;
  const Perspective& run = made.value();
  const auto exact_at = [&](int k) {
    const mpz_class expected =
        oracle::rounded_down(oracle::in_perspective(from, to, from_depth, to_depth, steps, k));
    require(expected == run.at(k), "Perspective: not the exact value");
    return run.at(k);
  };
  exact_at(0);
  exact_at(steps);
  if (steps > 300) {
    exact_at(static_cast<int>(static_cast<std::uint32_t>(in.any()) % static_cast<std::uint32_t>(steps)));
    return;
  }
  std::vector<int> exact;
  for (int k = 0; k <= steps; ++k) exact.push_back(exact_at(k));
  const int begin = in.byte() % (steps + 1);
  check_rung<PerspectiveEveryPixel>(run, exact, begin);
  check_rung<PerspectiveEvery<16>>(run, exact, begin);
  check_rung<PerspectiveEvery<8>>(run, exact, begin);
  check_rung<PerspectiveAffine>(run, exact, begin);
}

}  // namespace fuzz
