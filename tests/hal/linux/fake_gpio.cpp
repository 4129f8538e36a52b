// SPDX-License-Identifier: MIT
#include "fake_gpio.hpp"

#include <algorithm>
#include <cerrno>
#include <memory>

namespace fake_gpio {

namespace {
std::unique_ptr<Kernel> the_kernel = std::make_unique<Kernel>();
constexpr std::size_t queue_size = 16;

int fail(int error) {
  errno = error;
  return -1;
}
}  // namespace

Kernel& kernel() { return *the_kernel; }
void reset() {
  const Overflow overflow = the_kernel->overflow;
  the_kernel = std::make_unique<Kernel>();
  the_kernel->overflow = overflow;
}

bool Kernel::call() {
  if (calls_left > 0) {
    --calls_left;
    return true;
  }
  if (failures <= 0) return true;
  --failures;
  errno = error;
  return false;
}

Chip* Kernel::open_chip(const std::string& path) {
  const auto found = chips.find(path);
  if (found == chips.end() || found->second.open_error != 0) {
    errno = found == chips.end() ? ENOENT : found->second.open_error;
    return nullptr;
  }
  ++open;
  return &found->second;
}

bool Kernel::take(Chip& chip, unsigned line, const char* consumer) {
  if (!call()) return false;
  if (!chip.lines.at(line).consumer.empty()) return fail(EBUSY) == 0;
  chip.lines[line].consumer = consumer;
  ++held;
  return true;
}

void Kernel::give(Chip& chip, unsigned line) {
  chip.lines.at(line).consumer.clear();
  --held;
}

bool Kernel::set(Chip& chip, const std::vector<unsigned>& lines, const int* values) {
  if (!call()) return false;
  for (std::size_t i = 0; i < lines.size(); ++i) chip.lines.at(lines[i]).value = values[i];
  on_set(chip);
  return true;
}

void Kernel::queue_due() {
  for (; !edges.empty() && edges.front() <= clock.now(); edges.pop_front()) {
    if (queue_.size() < queue_size) {
      queue_.push_back(edges.front());
    } else if (overflow == Overflow::drops_oldest) {
      queue_.pop_front();
      queue_.push_back(edges.front());
    }
  }
}

int Kernel::wait(hal::Nanoseconds timeout) {
  if (!call()) return -1;
  if (signals > 0 && timeout > 0) {
    --signals;
    clock.advance(timeout / 3U);
    return fail(EINTR);
  }
  if (storm) return 1;
  queue_due();
  if (!queue_.empty()) return 1;
  const hal::Nanoseconds end = clock.now() + timeout;
  clock.wait_until(!edges.empty() && edges.front() < end ? edges.front() : end);
  queue_due();
  return queue_.empty() ? 0 : 1;
}

int Kernel::read(hal::Nanoseconds* times, int most) {
  if (!call()) return -1;
  if (storm) {
    std::fill_n(times, most, clock.now());
    return most;
  }
  int count = 0;
  for (; count < most && !queue_.empty(); queue_.pop_front()) times[count++] = queue_.front();
  if (count > 0) on_edges_read();
  return count;
}

}  // namespace fake_gpio
