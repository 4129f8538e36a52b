// SPDX-License-Identifier: MIT
//
// GPIO lines of Linux: outputs one by one or several at a time, and the tearing-effect line.
//
// Rule: a line is held from construction to destruction, so the kernel gives it free on every way out. What
// can't be set up throws a `DeviceError` that names chip and line.
#pragma once

#include <hal/bus.hpp>
#include <hal/linux/gpiod.hpp>
#include <hal/linux/trouble.hpp>
#include <hal/pin.hpp>
#include <hal/vblank.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace hal::linux_io {

/// Which line: by number or name, of a chip by name ("gpiochip0"), number ("0"), path or label.
struct LineAddress {
  std::string chip;
  std::string line;
  friend bool operator==(const LineAddress&, const LineAddress&) = default;
};

/// Reads "LINE" or "CHIP:LINE".
[[nodiscard]] LineAddress line_address(std::string_view text, std::string_view default_chip);

/// Lines of one chip that this program holds, with the names they go by in messages.
class HeldLines {
 public:
  /// For output, bit i of `values` the i-th at first. Throws DeviceError.
  static HeldLines outputs(const std::vector<LineAddress>& lines, unsigned values);
  /// To watch for rising edges. Throws DeviceError.
  static HeldLines edges(const LineAddress& line);

  [[nodiscard]] gpiod::Request& request() noexcept { return request_; }
  /// "GPIO line 25 (DC) of gpiochip0"
  [[nodiscard]] const std::string& name() const noexcept { return name_; }

 private:
  HeldLines(gpiod::Request request, std::string name)
      : request_(std::move(request)), name_(std::move(name)) {}
  gpiod::Request request_;
  std::string name_;
};

/// One output line.
class OutputLine final : public OutputPin {
 public:
  /// Throws DeviceError.
  OutputLine(const LineAddress& line, bool high) : lines_(HeldLines::outputs({line}, high ? 1U : 0U)) {}
  [[nodiscard]] const std::string& fault() const noexcept { return fault_.text(); }

 private:
  Status do_set(bool high) noexcept override;
  HeldLines lines_;
  Fault fault_;
};

/// SPI from three lines (or two, where the panel is always selected), for pins without an SPI driver. Mode 0,
/// most significant bit first.
class BitBangSpi final : public SpiBus {
 public:
  /// Clock, data and perhaps select, all of one chip, for one call of the kernel sets them together. Throws
  /// DeviceError.
  explicit BitBangSpi(const std::vector<LineAddress>& lines);
  [[nodiscard]] const std::string& fault() const noexcept { return fault_.text(); }

 private:
  Status do_write(std::span<const std::uint8_t> bytes) noexcept override;
  Status set(unsigned values) noexcept;
  Status send(std::span<const std::uint8_t> bytes) noexcept;
  HeldLines lines_;
  Fault fault_;
};

/// VBLANKs as a panel's tearing-effect line tells them, by the kernel's own timestamps.
///
/// The kernel keeps `gpiod::queued_edges` edges for a program that comes late. If they were too few, the time
/// between edges says how many were lost. A line that is silent for a quarter of a second (or four refreshes)
/// is stood in for by a timer of the nominal rate, until it is heard again; `take_notices` says so.
class TeLine final : public VblankSource {
 public:
  /// `clock` counts as the kernel's timestamps do; `refresh_millihertz` >= 1. Throws DeviceError.
  TeLine(const LineAddress& line, Clock& clock, std::uint32_t refresh_millihertz);

  [[nodiscard]] const std::string& name() const noexcept { return line_.name(); }
  [[nodiscard]] const std::string& fault() const noexcept { return fault_.text(); }
  /// True while the timer stands in.
  [[nodiscard]] bool silent() const noexcept { return silent_; }
  /// How often the line fell silent.
  [[nodiscard]] std::uint32_t silences() const noexcept { return silences_; }
  /// What happened since the last call, whole lines.
  [[nodiscard]] std::string take_notices();

 private:
  std::uint32_t do_count() noexcept override;
  Status do_wait() noexcept override;
  Nanoseconds do_last() noexcept override { return counted_ ? last_ : 0; }

  /// Waits for an edge until `deadline` and counts those that came. 1: some, 0: none, -1: errno.
  int take_edges(Nanoseconds deadline) noexcept;
  void count_edge(Nanoseconds time, bool lost_some) noexcept;
  /// Counts the ticks of the timer that are due.
  void count_ticks(Nanoseconds now) noexcept;
  void fall_silent(Nanoseconds now) noexcept;
  void say(const char* words) noexcept;

  HeldLines line_;
  Clock* clock_;
  Nanoseconds nominal_;
  Nanoseconds period_;  // As it was measured.
  Nanoseconds last_;
  std::uint32_t count_ = 0;
  std::uint32_t silences_ = 0;
  bool counted_ = false;
  bool was_full_ = false;  // The kernel's queue, at the last reading.
  bool silent_ = false;
  Fault fault_;
  std::string notices_;
};

}  // namespace hal::linux_io
