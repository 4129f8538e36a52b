// SPDX-License-Identifier: MIT
//
// What the accuracy lab measures: families of rungs, each with the loads it is measured under.
//
// Rule: a family's header in families/ says which rungs there are, how one is called, and with what; the same
// header is compiled for every core, to count instructions (count/), and for the desk, to measure errors
// (host/lab/errors). A rung is one type and one line in its family's list. A *load* is a distribution of
// inputs that programs really have; its inputs follow from their number alone, so they are the same
// everywhere.
#pragma once

#include <intaglio/image/format.hpp>
#include <intaglio/image/surface.hpp>
#include <intaglio/number/bound.hpp>

#include <concepts>
#include <cstdint>
#include <string_view>
#include <type_traits>

namespace lab {

namespace image = intaglio::image;
namespace number = intaglio::number;

/// A distribution of inputs.
struct Load {
  std::string_view name;
  /// How many inputs one count is made of, 1..most_calls.
  int calls;
};

inline constexpr int most_calls = 1024;

/// Numbers that look random and are the same on every core (xorshift, period 2^32 - 1).
class Random {
 public:
  /// Different seeds begin far apart.
  constexpr explicit Random(std::uint32_t seed) noexcept : state_(seed * 2'654'435'761U + 0x9E37'79B9U) {
    if (state_ == 0) state_ = 1;
    for (int i = 0; i < 4; ++i) bits();
  }
  constexpr std::uint32_t bits() noexcept {
    state_ ^= state_ << 13U;
    state_ ^= state_ >> 17U;
    state_ ^= state_ << 5U;
    return state_;
  }
  /// first..last, near enough evenly; last - first below 2^31.
  constexpr int between(int first, int last) noexcept {
    const auto size = static_cast<std::uint64_t>(std::int64_t{last} - first + 1);
    return static_cast<int>(first + static_cast<std::int64_t>(bits() * size >> 32U));
  }

 private:
  std::uint32_t state_;
};

/// What a family that draws draws on: 320x240, 8 bits a pixel.
[[nodiscard]] image::Surface<image::Indexed8> canvas() noexcept;
void clear_canvas() noexcept;

/// The rung that does nothing: what the harness costs.
struct Nothing {
  static constexpr number::Bound bound{};
};

/// A family: the rungs, how to call one (`run<R>(input)`, its result in 32 bits), and inputs.
template <class F>
concept FamilyOfRungs = requires(const typename F::Input& input) {
  { F::name } -> std::convertible_to<std::string_view>;
  { F::title } -> std::convertible_to<std::string_view>;
  { F::loads[0] } -> std::convertible_to<const Load&>;
  { F::input(0, 0) } -> std::same_as<typename F::Input>;
  { F::template run<typename F::Default>(input) } -> std::same_as<std::uint32_t>;
  requires std::is_trivially_copyable_v<typename F::Input>;
  typename F::Rungs;
};

/// What one call's cost is divided by: `F::units(input)` of `F::per`, or one call.
template <FamilyOfRungs F>
[[nodiscard]] constexpr int units(const typename F::Input& input) noexcept {
  if constexpr (requires { F::units(input); }) {
    return F::units(input);
  } else {
    return 1;
  }
}
template <FamilyOfRungs F>
[[nodiscard]] constexpr std::string_view per() noexcept {
  if constexpr (requires { F::per; }) {
    return F::per;
  } else {
    return "call";
  }
}

/// True if a rung takes all inputs of a load: `F::takes<R>(load)`, or always. Others it would refuse, so it
/// isn't measured under that load. A rung whose domain isn't all of its family's says in words what it is:
/// `static constexpr std::string_view domain`.
template <FamilyOfRungs F, class R>
[[nodiscard]] constexpr bool takes(int load) noexcept {
  if constexpr (requires { F::template takes<R>(load); }) {
    return F::template takes<R>(load);
  } else {
    return true;
  }
}

/// Makes the canvas what a load begins with: empty, or what `F::prepare(load)` draws then. Not counted.
template <FamilyOfRungs F>
void prepare(int load) noexcept {
  clear_canvas();
  if constexpr (requires { F::prepare(load); }) F::prepare(load);
}

/// The bound of a rung under a load.
template <FamilyOfRungs F, class R>
[[nodiscard]] constexpr number::Bound bound(int load) noexcept {
  if constexpr (requires { F::template bound<R>(load); }) {
    return F::template bound<R>(load);
  } else {
    return R::bound;
  }
}

/// Why the bound of a rung isn't tight, as the family or the rung says; empty if it is.
template <FamilyOfRungs F, class R>
[[nodiscard]] constexpr std::string_view slack() noexcept {
  if constexpr (requires { F::template slack<R>(); }) {
    return F::template slack<R>();
  } else if constexpr (requires { R::slack; }) {
    return R::slack;
  } else {
    return {};
  }
}

}  // namespace lab
