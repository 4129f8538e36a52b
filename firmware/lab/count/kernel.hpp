// SPDX-License-Identifier: MIT
//
// One count: a rung called with every input of a load.
//
// Rule: `kernel` is the loop that is counted, weighed (its code and tables are what the linker keeps for it)
// and repeated without a rung, to know what the loop itself costs. The compiler may inline the rung into it,
// as into any loop of a program, but knows nothing of the inputs and can't carry a result from one call to
// the next. After each count are reported: bytes of stack, and a digest of results and picture, which must be
// the same on every core.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <firmware/lab/count/probe.hpp>
#include <firmware/lab/count/stack_depth.hpp>
#include <firmware/lab/family.hpp>
#include <iterator>
#include <span>

namespace lab {

template <FamilyOfRungs F, class R>
[[gnu::noinline, gnu::noclone]] void kernel(const typename F::Input* inputs, int calls,
                                            std::uint32_t* results) noexcept {
  for (int i = 0; i < calls; ++i) {
    if constexpr (std::is_same_v<R, Nothing>) {
      results[i] = 0;
    } else {
      results[i] = F::template run<R>(inputs[i]);
    }
    asm volatile("" : : : "memory");
  }
}

namespace detail {

[[nodiscard]] std::uint32_t digest_of(std::span<const std::uint32_t> results) noexcept;

inline std::array<std::uint32_t, most_calls> results{};

template <FamilyOfRungs F, class R>
void count(const typename F::Input* inputs, int load) noexcept {
  if (!takes<F, R>(load)) return;
  const int calls = F::loads[load].calls;
  prepare<F>(load);
  const std::uintptr_t here = stack_pointer();
  StackDepth::paint();
  probe::begin();
  kernel<F, R>(inputs, calls, results.data());
  probe::end();
  probe::report(StackDepth::since_paint(here));
  probe::report(digest_of(std::span(results).first(static_cast<std::size_t>(calls))));
}

template <FamilyOfRungs F, class... R>
void count_all(number::Family<R...> /*rungs*/) noexcept {
  static std::array<typename F::Input, most_calls> inputs{};
  for (int load = 0; load < static_cast<int>(std::size(F::loads)); ++load) {
    const int calls = F::loads[load].calls;
    for (int i = 0; i < calls; ++i) inputs[static_cast<std::size_t>(i)] = F::input(load, i);
    count<F, Nothing>(inputs.data(), load);
    (count<F, R>(inputs.data(), load), ...);
  }
}

}  // namespace detail

/// Counts a family: load by load, first the loop alone, then the rungs that take the load in order.
template <FamilyOfRungs F>
void count_family() noexcept {
  detail::count_all<F>(typename F::Rungs{});
}

}  // namespace lab
