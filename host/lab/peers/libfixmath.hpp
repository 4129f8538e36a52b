// SPDX-License-Identifier: MIT
//
// What libfixmath and this library both compute, as families of the accuracy lab: each counted by the same
// loop, each with inputs in its own format, which stand for the same values.
#pragma once

#include <intaglio/number/angle.hpp>
#include <intaglio/number/division.hpp>
#include <intaglio/number/root.hpp>

#include <concepts>
#include <cstdint>
#include <firmware/lab/families/arc_tangent.hpp>
#include <firmware/lab/families/sine.hpp>
#include <firmware/lab/family.hpp>
#include <libfixmath/fix16.h>
#include <limits>
#include <string_view>
#include <type_traits>

namespace lab {

/// libfixmath states no bounds.
struct Unstated {
  static constexpr number::Bound bound{std::numeric_limits<std::int32_t>::max(), number::Unit::lsb_q16};
};

struct Fix16Sin : Unstated {
  fix16_t operator()(fix16_t angle) const noexcept { return fix16_sin(angle); }
};
struct Fix16SinParabola : Unstated {
  fix16_t operator()(fix16_t angle) const noexcept { return fix16_sin_parabola(angle); }
};
struct Fix16Sqrt : Unstated {
  fix16_t operator()(fix16_t x) const noexcept { return fix16_sqrt(x); }
};
struct Fix16Div : Unstated {
  fix16_t operator()(fix16_t a, fix16_t b) const noexcept { return fix16_div(a, b); }
};
struct Fix16Atan2 : Unstated {
  fix16_t operator()(fix16_t y, fix16_t x) const noexcept { return fix16_atan2(y, x); }
};

/// isqrt_nearest in the format 16.16.
struct IsqrtNearest : Unstated {
  fix16_t operator()(fix16_t x) const noexcept {
    return static_cast<fix16_t>(number::isqrt_nearest(std::uint64_t{static_cast<std::uint32_t>(x)} << 16U));
  }
};
/// round_div in the format 16.16.
struct RoundDiv : Unstated {
  fix16_t operator()(fix16_t a, fix16_t b) const noexcept {
    return static_cast<fix16_t>(number::round_div(std::int64_t{a} * fix16_one, std::int64_t{b}));
  }
};

/// Of an angle in radians in 16.16, or of a binary angle.
struct PeerSine {
  static constexpr std::string_view name = "sine";
  static constexpr std::string_view title = "Sine, within one turn";
  template <class... Ours>
  static auto with(number::Family<Ours...>) -> number::Family<Fix16Sin, Fix16SinParabola, Ours...>;
  using Rungs = decltype(with(Sine::Rungs{}));
  using Default = Sine::Default;
  static constexpr Load loads[] = {{"any angle", 256}, {"16 angles again and again", 256}};

  struct Input {
    fix16_t radians = 0;
    number::Angle angle{};
  };
  static Input input(int load, int i) noexcept {
    Random random(static_cast<std::uint32_t>(load == 1 ? i % 16 : i));
    return {random.between(-fix16_pi, fix16_pi), number::Angle::from_steps(random.between(0, 65535))};
  }
  template <class R>
  static std::uint32_t run(const Input& in) noexcept {
    if constexpr (std::is_invocable_v<R, fix16_t>) {
      return static_cast<std::uint32_t>(R{}(in.radians));
    } else {
      return static_cast<std::uint32_t>(R{}(in.angle).raw());
    }
  }
};

/// Of an angle beyond one turn, which the parabola doesn't take.
struct PeerTurns : PeerSine {
  static constexpr std::string_view name = "turns";
  static constexpr std::string_view title = "Sine, up to 5,215 turns";
  using Rungs = number::Family<Fix16Sin, Default>;
  static constexpr Load loads[] = {{"any angle", 256}};
  static Input input(int /*load*/, int i) noexcept {
    Random random(static_cast<std::uint32_t>(i));
    const int radians = static_cast<int>(random.bits());
    return {radians, number::Angle::from_steps(static_cast<int>(random.bits()))};
  }
};

struct PeerSquareRoot {
  static constexpr std::string_view name = "square-root";
  static constexpr std::string_view title = "Square root";
  using Rungs = number::Family<Fix16Sqrt, IsqrtNearest>;
  using Default = IsqrtNearest;
  static constexpr Load loads[] = {{"0 to 1", 256}, {"1 to 32767", 256}};
  using Input = fix16_t;
  static Input input(int load, int i) noexcept {
    Random random(static_cast<std::uint32_t>(i));
    return load == 0 ? random.between(0, fix16_one) : random.between(fix16_one, fix16_maximum - 1);
  }
  template <class R>
  static std::uint32_t run(Input x) noexcept {
    return static_cast<std::uint32_t>(R{}(x));
  }
};

struct FixPair {
  fix16_t first = 0;
  fix16_t second = 1;
};

struct PeerDivision {
  static constexpr std::string_view name = "division";
  static constexpr std::string_view title = "Division, where the quotient fits";
  using Rungs = number::Family<Fix16Div, RoundDiv>;
  using Default = RoundDiv;
  static constexpr Load loads[] = {{"ratios of lengths", 256}, {"numbers of any size", 256}};
  using Input = FixPair;
  static Input input(int load, int i) noexcept {
    Random random(static_cast<std::uint32_t>(i));
    if (load == 0) return {random.between(0, 320 * fix16_one), random.between(fix16_one, 320 * fix16_one)};
    const int divisor =
        1 + static_cast<int>(random.bits() >> 1U >> static_cast<unsigned>(random.between(0, 30)));
    const std::int64_t most = std::int64_t{divisor} << 14U;
    return {random.between(0, static_cast<int>(most < fix16_maximum ? most : fix16_maximum - 1)), divisor};
  }
  template <class R>
  static std::uint32_t run(const Input& in) noexcept {
    return static_cast<std::uint32_t>(R{}(in.first, in.second));
  }
};

struct PeerArcTangent {
  static constexpr std::string_view name = "arc-tangent";
  static constexpr std::string_view title = "Direction of a vector (atan2)";
  template <class... Ours>
  static auto with(number::Family<Ours...>) -> number::Family<Fix16Atan2, Ours...>;
  using Rungs = decltype(with(ArcTangent::Rungs{}));
  using Default = ArcTangent::Default;
  static constexpr Load loads[] = {{"lengths up to 320", 256}};
  using Input = FixPair;
  static Input input(int /*load*/, int i) noexcept {
    Random random(static_cast<std::uint32_t>(i));
    const auto length = [&random] { return random.between(-320 * fix16_one, 320 * fix16_one); };
    const fix16_t y = length();
    return {y, length()};
  }
  template <class R>
  static std::uint32_t run(const Input& in) noexcept {
    if constexpr (std::is_same_v<R, Fix16Atan2>) {
      return static_cast<std::uint32_t>(R{}(in.first, in.second));
    } else {
      return static_cast<std::uint32_t>(R{}(in.second, in.first).steps());
    }
  }
};

}  // namespace lab
