// SPDX-License-Identifier: MIT
//
// The family of clipped lines: with parameters of 16 or 32 fraction bits, and exactly, by three clippers. All
// round the ends once to 1/256 pixel.
#pragma once

#include <intaglio/clip/line_window.hpp>
#include <intaglio/linear/point.hpp>
#include <intaglio/linear/sub_rect.hpp>
#include <intaglio/number/long_division.hpp>

#include <algorithm>
#include <cstdint>
#include <firmware/lab/family.hpp>
#include <string_view>
#include <type_traits>

namespace lab {

/// The ends of what is inside, if anything is.
struct ClippedEnds {
  bool visible = false;
  intaglio::linear::SubPoint from{};
  intaglio::linear::SubPoint to{};
};

/// Liang and Barsky's way with parameters rounded to so many fraction bits, up to 32; products have 62 bits.
/// A parameter is half a unit of its last place off, so an end by half of that share of the line, and as far
/// as rounding a coordinate takes it.
template <int fraction_bits>
struct RoundedParameters {
  ClippedEnds operator()(intaglio::linear::SubPoint a, intaglio::linear::SubPoint b,
                         const intaglio::linear::SubRect& window) const noexcept {
    std::int64_t enter = 0;
    std::int64_t leave = one;
    const int dx = b.x - a.x;
    const int dy = b.y - a.y;
    if (!cut(-dx, a.x - window.x, enter, leave) || !cut(dx, window.right() - a.x, enter, leave) ||
        !cut(-dy, a.y - window.y, enter, leave) || !cut(dy, window.bottom() - a.y, enter, leave))
      return {};
    return {
        true, {along(a.x, dx, enter), along(a.y, dy, enter)}, {along(a.x, dx, leave), along(a.y, dy, leave)}};
  }

 private:
  static constexpr std::int64_t one = std::int64_t{1} << fraction_bits;

  /// Leaves the parameters t with t * p <= q; false if there are none.
  static bool cut(int p, int q, std::int64_t& enter, std::int64_t& leave) noexcept {
    if (p == 0) return q >= 0;
    const bool entering = p < 0;
    const int numerator = entering ? -q : q;
    const int denominator = entering ? -p : p;
    if (numerator <= 0) return entering || numerator == 0 ? stays(entering, 0, enter, leave) : false;
    if (numerator >= denominator)
      return !entering || numerator == denominator ? stays(entering, one, enter, leave) : false;
    const std::uint64_t scaled =
        (static_cast<std::uint64_t>(numerator) << static_cast<unsigned>(fraction_bits)) +
        static_cast<unsigned>(denominator) / 2;
    const std::int64_t t = number::long_divide(scaled, static_cast<std::uint32_t>(denominator)).quotient;
    return stays(entering, t, enter, leave);
  }
  static bool stays(bool entering, std::int64_t t, std::int64_t& enter, std::int64_t& leave) noexcept {
    if (entering)
      enter = std::max(enter, t);
    else
      leave = std::min(leave, t);
    return enter <= leave;
  }
  static int along(int from, int way, std::int64_t t) noexcept {
    return from + static_cast<int>((way * t + one / 2) >> static_cast<unsigned>(fraction_bits));
  }
};

struct Parameters16 : RoundedParameters<16> {
  static constexpr number::Bound bound = number::pixels(22'631);
};
struct Parameters32 : RoundedParameters<32> {
  static constexpr number::Bound bound = number::pixels(4);
};

/// What the exact clippers have in common.
template <auto clipper>
struct ExactClipper {
  static constexpr number::Bound bound = number::pixels(2);
  ClippedEnds operator()(intaglio::linear::SubPoint a, intaglio::linear::SubPoint b,
                         const intaglio::linear::SubRect& window) const noexcept {
    const auto line = clipper(a, b, window);
    if (!line.ok() || !line.value().visible) return {};
    return {true, nearest(line.value().from), nearest(line.value().to)};
  }
};
struct CohenSutherland : ExactClipper<intaglio::clip::cohen_sutherland> {};
struct Skala : ExactClipper<intaglio::clip::skala> {};
struct LiangBarsky : ExactClipper<intaglio::clip::liang_barsky> {};

struct LineClip {
  static constexpr std::string_view name = "line-clip";
  static constexpr std::string_view title = "Clipping a line to the screen";
  using Rungs = number::Family<Parameters16, Parameters32, LiangBarsky, CohenSutherland, Skala>;
  using Default = LiangBarsky;
  static constexpr Load loads[] = {
      {"ends around the screen", 128}, {"most lines inside", 128}, {"ends up to a million pixels away", 128}};
  static constexpr intaglio::linear::SubRect window{0, 0, 319 * 256, 239 * 256};
  /// How far the ends of a load are from the middle of the screen, in pixels.
  static constexpr int reach[] = {512, 200, 1 << 20};

  struct Input {
    intaglio::linear::SubPoint from;
    intaglio::linear::SubPoint to;
  };
  static Input input(int load, int i) noexcept {
    Random random(static_cast<std::uint32_t>(i + 1));
    if (load == 1) {
      return {{random.between(-2'000, 322 * 256), random.between(-2'000, 242 * 256)},
              {random.between(-2'000, 322 * 256), random.between(-2'000, 242 * 256)}};
    }
    const int far = load == 0 ? 256 * 350 : 256 * 1'000'000;
    const intaglio::linear::SubPoint from{random.between(-far, far), random.between(-far, far)};
    // Three of four go somewhere through the screen, or end there.
    if (load == 0 || i % 4 == 0)
      return {{from.x + 160 * 256, from.y + 120 * 256}, {random.between(0, 319 * 256), -from.y}};
    return {from, {-from.x + random.between(0, 600 * 256), -from.y + random.between(0, 400 * 256)}};
  }
  template <class R>
  static std::uint32_t run(const Input& line) noexcept {
    const ClippedEnds ends = R{}(line.from, line.to, window);
    if (!ends.visible) return 0;
    return static_cast<std::uint32_t>(ends.from.x * 31 + ends.from.y * 37 + ends.to.x * 41 + ends.to.y * 43) |
           1U;
  }

  /// The distance of an end from its exact place, in pixels. Exactly clipped ends lie on a side of the
  /// window, so only one coordinate is rounded: 1/512. Rounded parameters: at most sqrt(2) * (1/512 + L *
  /// 2^-(bits + 1)) with coordinates that differ by up to L.
  template <class R>
  static constexpr number::Bound bound(int load) noexcept {
    constexpr int of_16_bits[] = {14, 7, 22'631};
    constexpr int of_32_bits[] = {3, 3, 4};
    int thousandths = 2;
    if (std::is_same_v<R, Parameters16>) thousandths = of_16_bits[load];
    if (std::is_same_v<R, Parameters32>) thousandths = of_32_bits[load];
    return number::pixels(thousandths);
  }
};

}  // namespace lab
