// SPDX-License-Identifier: MIT
//
// How a request to show a frame gets from the program to an interrupt handler: buffer and colours together,
// or not at all.
//
// Rule: a request is withdrawn before it is changed and published after, so the VBLANK interrupt finds a
// whole one or none. The handler puts it on display (or begins to send it), says which buffer that is, and
// only then takes the request back. While a frame is being sent, its buffer counts as on display, and no
// other is begun. One core: the program is interrupted, an interrupt isn't. Each step is one access to a cell
// that interrupts share with the program, so `Cell` must keep the order of accesses (`InterruptCell` does).
// Each part of the rule is named in `SwapProtocolGuards`, so a test can leave it out and see that it is
// needed: tests/present/interleavings.cpp runs this very code through all interleavings.
#pragma once

#include <hal/panel.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

namespace hal {

/// A value that a program and its interrupts share on one core. The compiler moves no access across another.
template <class T>
class InterruptCell {
 public:
  constexpr InterruptCell() noexcept = default;
  explicit constexpr InterruptCell(T value) noexcept : value_(value) {}
  [[nodiscard]] T load() const noexcept {
    std::atomic_signal_fence(std::memory_order_seq_cst);
    const T value = value_.load(std::memory_order_relaxed);
    std::atomic_signal_fence(std::memory_order_seq_cst);
    return value;
  }
  void store(T value) noexcept {
    std::atomic_signal_fence(std::memory_order_seq_cst);
    value_.store(value, std::memory_order_relaxed);
    std::atomic_signal_fence(std::memory_order_seq_cst);
  }

 private:
  std::atomic<T> value_{};
};

/// What keeps program and interrupts from each other's throats.
struct SwapProtocolGuards {
  /// A request is withdrawn before it is changed,
  static constexpr bool withdraws = true;
  /// and published when it is whole.
  static constexpr bool publishes_last = true;
  /// Colours of a request replaced stay where the later one brings none.
  static constexpr bool joins_colours = true;
  /// The interrupt takes a request only if there is one,
  static constexpr bool asks_first = true;
  /// notes which buffer it put on display,
  static constexpr bool notes_buffer = true;
  /// and takes the request back.
  static constexpr bool takes_back = true;
  /// No frame is sent before the last one is through.
  static constexpr bool one_at_a_time = true;
};

/// Whether the device goes on reading the buffer on display, or is sent it once.
enum class Feed : std::uint8_t { scans_out, sends };

template <template <class> class Cell, class Colour, std::size_t most_colours, Feed feed,
          class Guards = SwapProtocolGuards>
class SwapProtocol {
 public:
  // In the program:

  /// Asks that from the next VBLANK on `buffer` be shown, with `count` colours from entry 0 on, of which
  /// `colour(i)` is the i-th. Replaces a request that waits.
  template <class Colours>
  void request(int buffer, std::size_t count, const Colours& colour) noexcept {
    // Asked in this order and once more when it is withdrawn: what became of the request before is then sure.
    const std::uint32_t taken = taken_.load();
    const bool waited = pending();
    if (Guards::withdraws) requested_.store(false);
    replaced_ = waited && taken_.load() == taken;
    if (!Guards::publishes_last) requested_.store(true);
    buffer_.store(buffer);
    const std::size_t before = Guards::joins_colours && replaced_ ? count_.load() : 0;
    count_.store(std::max(before, count));
    for (std::size_t i = 0; i < count; ++i) colours_[i].store(colour(i));
    if (Guards::publishes_last) requested_.store(true);
  }
  /// True while a request waits for its VBLANK.
  [[nodiscard]] bool pending() const noexcept { return requested_.load(); }
  /// True if the last request replaced one that hadn't been taken.
  [[nodiscard]] bool replaced() const noexcept { return replaced_; }
  /// The buffer on display or being sent, or `Panel::nothing`.
  [[nodiscard]] int on_display() const noexcept { return on_display_.load(); }
  [[nodiscard]] std::uint32_t vblanks() const noexcept { return vblanks_.load(); }

  // In interrupts:

  /// The handler of the VBLANK. `latch(buffer, count, colour)` puts a frame on display or begins to send it;
  /// `colour(i)` is the i-th colour.
  template <class Latch>
  void on_vblank(const Latch& latch) noexcept {
    vblanks_.store(vblanks_.load() + 1U);
    if (feed == Feed::sends && Guards::one_at_a_time && on_display_.load() != Panel::nothing) return;
    if (Guards::asks_first && !requested_.load()) return;
    const int buffer = buffer_.load();
    if (Guards::notes_buffer) on_display_.store(buffer);
    latch(buffer, count_.load(), [this](std::size_t i) noexcept { return colours_[i].load(); });
    taken_.store(taken_.load() + 1U);
    if (Guards::takes_back) requested_.store(false);
  }
  /// The handler of the end of a transfer: the frame is out, and its buffer free.
  void on_sent() noexcept { on_display_.store(Panel::nothing); }

 private:
  Cell<bool> requested_{false};
  Cell<int> buffer_{0};
  Cell<int> on_display_{feed == Feed::sends ? Panel::nothing : 0};
  Cell<std::size_t> count_{0};
  Cell<std::uint32_t> vblanks_{0};
  Cell<std::uint32_t> taken_{0};  // Requests put on display.
  std::array<Cell<Colour>, most_colours> colours_{};
  bool replaced_ = false;
};

}  // namespace hal
