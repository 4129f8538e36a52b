// SPDX-License-Identifier: MIT
//
// Plays the tearing-effect output of a display controller on a line of gpio-sim.
//
//   te_generator PULL_FILE HERTZ PULSES     e.g. /sys/devices/platform/gpio-sim.0/gpiochip0/sim_gpio0/pull 60
//   600
//
// Raises the line at the start of every period and lowers it a millisecond later. Periods are counted from
// the start, so that one late pulse doesn't shift the next. PULSES 0: until it is killed.
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <sched.h>
#include <string_view>
#include <thread>
#include <unistd.h>

int main(int argc, char** argv) {
  if (argc != 4) return 2;
  using Clock = std::chrono::steady_clock;
  const int pull = open(argv[1], O_WRONLY | O_CLOEXEC);
  if (pull < 0) {
    std::perror(argv[1]);
    return 1;
  }
  const auto period = std::chrono::nanoseconds(1'000'000'000 / std::atoi(argv[2]));
  const int pulses = std::atoi(argv[3]);
  // Real controllers don't wait for the processor.
  const sched_param most{.sched_priority = 50};
  if (sched_setscheduler(0, SCHED_FIFO, &most) != 0) std::perror("te_generator: no real-time priority");
  const auto set = [pull](std::string_view level) {
    return pwrite(pull, level.data(), level.size(), 0) == static_cast<ssize_t>(level.size());
  };
  const Clock::time_point start = Clock::now();
  Clock::duration latest{};
  for (int n = 1; pulses == 0 || n <= pulses; ++n) {
    const auto due = start + n * period;
    std::this_thread::sleep_until(due);
    latest = std::max(latest, Clock::now() - due);
    if (!set("pull-up")) return 1;
    std::this_thread::sleep_until(due + std::chrono::milliseconds(1));
    if (!set("pull-down")) return 1;
  }
  std::printf("pulses %d latest_us %lld\n", pulses,
              static_cast<long long>(std::chrono::duration_cast<std::chrono::microseconds>(latest).count()));
  return 0;
}
