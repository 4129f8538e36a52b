// SPDX-License-Identifier: MIT
#include <hal/linux/gpio.hpp>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <new>
#include <utility>

namespace hal::linux_io {

namespace {

std::optional<unsigned> number(std::string_view text) {
  unsigned value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::string quoted(const std::string& text) { return '\'' + text + '\''; }

/// The file of a chip called by number, name or path; "" for what can only be a label.
std::string path_of(const std::string& chip) {
  if (chip.starts_with('/')) return chip;
  if (chip.starts_with("gpiochip")) return "/dev/" + chip;
  return number(chip) ? "/dev/gpiochip" + chip : std::string();
}

struct OpenChip {
  gpiod::Chip chip;
  std::string name;  // For messages.
};

[[noreturn]] void refuse_chip(const std::string& path, int error) {
  if (error == EOPNOTSUPP)
    throw DeviceError("this build can't drive GPIO lines: it was made without libgpiod");
  if (error == ENOTTY || error == EINVAL)
    throw DeviceError(path + " is no GPIO chip; gpiodetect names those");
  throw DeviceError(cannot_open(path, "GPIO chip", error));
}

OpenChip open_labelled(const std::string& label) {
  constexpr unsigned most = 64;
  std::string seen;
  std::string closed;  // The first that can't be opened.
  int why = 0;
  for (unsigned i = 0; i < most; ++i) {
    const std::string name = "gpiochip" + std::to_string(i);
    const std::string path = "/dev/" + name;
    auto chip = gpiod::Chip::open(path);
    if (!chip) {
      if (closed.empty() && errno != ENOENT) {
        why = errno;
        closed = path;
      }
      continue;
    }
    if (chip->label() == label) return {std::move(*chip), name};
    seen += (seen.empty() ? " " : ", ") + name + " [" + chip->label() + ']';
  }
  if (seen.empty() && !closed.empty()) refuse_chip(closed, why);
  throw DeviceError("no GPIO chip is called " + quoted(label) +
                    (seen.empty() ? "; there is none" : "; there are" + seen));
}

OpenChip open_chip(const std::string& chip) {
  const std::string path = path_of(chip);
  if (path.empty()) return open_labelled(chip);
  auto opened = gpiod::Chip::open(path);
  if (opened) return {std::move(*opened), path.substr(path.rfind('/') + 1)};
  refuse_chip(path, errno);
}

unsigned find_line(const OpenChip& of, const std::string& line) {
  const unsigned count = of.chip.line_count();
  // Lines without a name aren't called by it.
  if (const auto named = line.empty() ? std::nullopt : of.chip.find(line)) return *named;
  const auto numbered = number(line);
  if (!numbered)
    throw DeviceError("GPIO chip " + of.name + " has no line " + quoted(line) + "; gpioinfo names its lines");
  if (*numbered >= count)
    throw DeviceError("GPIO chip " + of.name +
                      (count == 0 ? " has no lines" : " has lines 0 to " + std::to_string(count - 1)) +
                      ", no " + line);
  return *numbered;
}

/// "25 (DC)"
std::string described(const OpenChip& of, unsigned line) {
  const std::string name = of.chip.name_of(line);
  return std::to_string(line) + (name.empty() ? "" : " (" + name + ')');
}

[[noreturn]] void refuse(const OpenChip& of, std::span<const unsigned> lines, int error) {
  std::string names;
  for (const unsigned line : lines) names += (names.empty() ? "" : ", ") + described(of, line);
  const std::string start = "GPIO line " + names + " of " + of.name;
  if (error != EBUSY) throw DeviceError(start + ": " + error_text(error));
  for (const unsigned line : lines) {
    const std::string holder = of.chip.consumer_of(line);
    if (!holder.empty())
      throw DeviceError("GPIO line " + described(of, line) + " of " + of.name + " is in use by " +
                        quoted(holder) + "; gpioinfo shows who holds which line");
  }
  throw DeviceError(start + " is in use by another program or a driver of the kernel");
}

}  // namespace

LineAddress line_address(std::string_view text, std::string_view default_chip) {
  const std::size_t colon = text.rfind(':');
  if (colon == std::string_view::npos) return {std::string(default_chip), std::string(text)};
  return {std::string(text.substr(0, colon)), std::string(text.substr(colon + 1))};
}

HeldLines HeldLines::outputs(const std::vector<LineAddress>& lines, unsigned values) {
  if (lines.empty() || lines.size() > gpiod::most_lines)
    throw DeviceError("GPIO lines are driven 1 to " + std::to_string(gpiod::most_lines) + " at a time, not " +
                      std::to_string(lines.size()));
  OpenChip of = open_chip(lines[0].chip);
  std::vector<unsigned> numbers;
  std::string name;
  for (const LineAddress& line : lines) {
    if (line.chip != lines[0].chip)
      throw DeviceError("GPIO lines that are driven together must be of one chip, not of " + lines[0].chip +
                        " and " + line.chip);
    numbers.push_back(find_line(of, line.line));
    if (std::count(numbers.begin(), numbers.end(), numbers.back()) > 1)
      throw DeviceError("GPIO line " + described(of, numbers.back()) + " of " + of.name + " is named twice");
    name += (name.empty() ? "GPIO line " : ", ") + described(of, numbers.back());
  }
  auto request = of.chip.request_outputs(numbers, values);
  if (!request) refuse(of, numbers, errno);
  return {std::move(*request), name + " of " + of.name};
}

HeldLines HeldLines::edges(const LineAddress& line) {
  OpenChip of = open_chip(line.chip);
  const unsigned found = find_line(of, line.line);
  auto request = of.chip.request_edges(found);
  if (!request) refuse(of, {&found, 1}, errno);
  return {std::move(*request), "GPIO line " + described(of, found) + " of " + of.name};
}

Status OutputLine::do_set(bool high) noexcept {
  if (lines_.request().set(high ? 1U : 0U)) return {};
  return fault_.note(lines_.name(), "driving it failed", errno, Part::pin);
}

namespace {
constexpr unsigned clock_bit = 1;
constexpr unsigned data_bit = 2;
constexpr unsigned select_bit = 4;
}  // namespace

BitBangSpi::BitBangSpi(const std::vector<LineAddress>& lines)
    : lines_(HeldLines::outputs(lines, select_bit)) {}

Status BitBangSpi::set(unsigned values) noexcept {
  if (lines_.request().set(values)) return {};
  return fault_.note(lines_.name(), "driving it failed", errno, Part::bus);
}

Status BitBangSpi::do_write(std::span<const std::uint8_t> bytes) noexcept {
  const Status sent = send(bytes);
  if (sent.ok()) return set(select_bit);
  // Deselected even so, the panel takes the next transfer from its first bit on.
  static_cast<void>(lines_.request().set(select_bit));
  return sent;
}

Status BitBangSpi::send(std::span<const std::uint8_t> bytes) noexcept {
  // Data change while the clock is low and are taken at its rising edge.
  for (const std::uint8_t byte : bytes)
    for (unsigned mask = 0x80; mask != 0; mask >>= 1U) {
      const unsigned data = (byte & mask) != 0 ? data_bit : 0U;
      if (const Status s = set(data); !s.ok()) return s;
      if (const Status s = set(data | clock_bit); !s.ok()) return s;
    }
  return set(0);
}

TeLine::TeLine(const LineAddress& line, Clock& clock, std::uint32_t refresh_millihertz)
    : line_(HeldLines::edges(line)),
      clock_(&clock),
      nominal_(1'000'000'000'000U / refresh_millihertz),
      period_(nominal_),
      last_(clock.now()) {}

std::string TeLine::take_notices() { return std::exchange(notices_, {}); }

void TeLine::say(const char* words) noexcept {
  constexpr std::size_t enough = 4096;
  if (notices_.size() > enough) return;
  try {
    notices_ += "tearing-effect line: " + line_.name() + ' ' + words + '\n';
  } catch (const std::bad_alloc&) {
    return;
  }
}

void TeLine::count_edge(Nanoseconds time, bool lost_some) noexcept {
  const Nanoseconds gap = time > last_ ? time - last_ : 0;
  std::uint32_t refreshes = 1;
  if (counted_ && !silent_) {
    if (lost_some) {
      refreshes = std::max(1U, static_cast<std::uint32_t>((gap + period_ / 2U) / period_));
    } else if (gap > nominal_ / 2U && gap < nominal_ * 2U) {
      period_ = (period_ * 7U + gap) / 8U;
    }
  }
  if (silent_) {
    silent_ = false;
    say("is heard again");
  }
  counted_ = true;
  count_ += refreshes;
  last_ = std::max(last_, time);
}

int TeLine::take_edges(Nanoseconds deadline) noexcept {
  // A line that never rests (a floating one, or a clock) must not hold the program.
  constexpr int most_readings = 64;
  bool any = false;
  for (int readings = 0; readings < most_readings;) {
    const Nanoseconds now = clock_->now();
    const auto left = any || now >= deadline ? 0 : static_cast<std::int64_t>(deadline - now);
    const int come = line_.request().wait(left);
    if (come == 0) return any ? 1 : 0;
    if (come < 0 && errno == EINTR) {
      if (left == 0) return any ? 1 : 0;
      continue;
    }
    if (come < 0) return -1;
    std::array<Nanoseconds, gpiod::queued_edges> times{};
    const int count = line_.request().read(times);
    if (count < 0) return -1;
    ++readings;
    const bool full = static_cast<std::size_t>(count) == times.size();
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
      count_edge(times[i], full || (was_full_ && i == 0));
    was_full_ = full;
    any = any || count > 0;
  }
  return any ? 1 : 0;
}

void TeLine::count_ticks(Nanoseconds now) noexcept {
  if (now < last_) return;
  const Nanoseconds ticks = (now - last_) / nominal_;
  if (ticks == 0) return;
  counted_ = true;
  count_ += static_cast<std::uint32_t>(ticks);
  last_ += ticks * nominal_;
}

void TeLine::fall_silent(Nanoseconds now) noexcept {
  silent_ = true;
  ++silences_;
  say("is silent; a timer stands in for it");
  count_ticks(now);
}

std::uint32_t TeLine::do_count() noexcept {
  // What goes wrong here is told by the next wait.
  static_cast<void>(take_edges(0));
  if (silent_) count_ticks(clock_->now());
  return count_;
}

Status TeLine::do_wait() noexcept {
  const std::uint32_t before = do_count();
  constexpr Nanoseconds patience = 250'000'000;
  const Nanoseconds now = clock_->now();
  const Nanoseconds deadline = silent_ ? last_ + nominal_ : now + std::max(patience, nominal_ * 4U);
  const int come = take_edges(deadline);
  if (come < 0) return fault_.note(line_.name(), "watching it failed", errno, Part::pin);
  if (come > 0) return {};
  if (silent_) {
    clock_->wait_until(deadline);
    count_ticks(clock_->now());
  } else {
    fall_silent(clock_->now());
  }
  return count_ != before ? Status{} : Status{Error::timeout, Part::pin};
}

}  // namespace hal::linux_io
