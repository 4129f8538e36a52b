// SPDX-License-Identifier: MIT
//
// GPIO chips that aren't there: what the kernel would know of them, in virtual time. libgpiod_1/ and
// libgpiod_2/ are the two interfaces of libgpiod to it, linked in place of the library.
#pragma once

#include <hal/sim/virtual_clock.hpp>

#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace fake_gpio {

struct Line {
  std::string name{};
  std::string consumer{};  ///< Not empty: held.
  int value = 0;
};

struct Chip {
  std::string label;
  std::vector<Line> lines;
  int open_error = 0;  ///< What `open` fails with.
};

enum class Overflow { drops_newest, drops_oldest };

class Kernel {
 public:
  std::map<std::string, Chip> chips;
  hal::sim::VirtualClock clock;
  /// Calls the kernel has left before every one fails with `error`.
  int calls_left = 1 << 30;
  int error = 0;
  int failures = 1 << 30;  ///< After so many of them all goes well again.
  bool storm = false;      ///< The line that is watched never rests.
  /// Waits that end early for a signal.
  int signals = 0;
  /// Called when lines were set, all of them at once.
  std::function<void(const Chip& chip)> on_set = [](const Chip&) {};
  int held = 0;  ///< Lines.
  int open = 0;  ///< Chips.

  /// Edges to come on the line that is watched, in order.
  std::deque<hal::Nanoseconds> edges;
  Overflow overflow = Overflow::drops_newest;
  /// Called when some were read.
  std::function<void()> on_edges_read = [] {};

  /// Errors: -1 and errno.
  Chip* open_chip(const std::string& path);
  bool take(Chip& chip, unsigned line, const char* consumer);
  void give(Chip& chip, unsigned line);
  bool set(Chip& chip, const std::vector<unsigned>& lines, const int* values);
  int wait(hal::Nanoseconds timeout);
  int read(hal::Nanoseconds* times, int most);

 private:
  bool call();
  /// Edges that are due go into the queue, which holds 16.
  void queue_due();
  std::deque<hal::Nanoseconds> queue_;
};

/// The kernel of the running test. `reset` makes a new one.
Kernel& kernel();
void reset();

}  // namespace fake_gpio
