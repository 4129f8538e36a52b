// SPDX-License-Identifier: MIT
//
// libgpiod 1.x (1.4 or later), as of Debian 12.
#include <hal/linux/gpiod.hpp>

#include <array>
#include <cerrno>
#include <ctime>
#include <gpiod.h>

namespace hal::linux_io::gpiod {

namespace {

constexpr std::int64_t second = 1'000'000'000;

std::string text(const char* words) { return words == nullptr ? std::string() : std::string(words); }

}  // namespace

struct Chip::Handle {
  gpiod_chip* chip;
  explicit Handle(gpiod_chip* opened) : chip(opened) {}
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  ~Handle() { gpiod_chip_close(chip); }
};

struct Request::Handle {
  std::shared_ptr<Chip::Handle> chip;  // Lines live in their chip.
  gpiod_line_bulk lines;
  explicit Handle(std::shared_ptr<Chip::Handle> of) : chip(std::move(of)), lines() {
    gpiod_line_bulk_init(&lines);
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  ~Handle() {
    if (held) gpiod_line_release_bulk(&lines);
  }
  bool held = false;
};

std::optional<Chip> Chip::open(const std::string& path) {
  gpiod_chip* const chip = gpiod_chip_open(path.c_str());
  if (chip == nullptr) return std::nullopt;
  return Chip(std::make_unique<Handle>(chip));
}

Chip::Chip(std::unique_ptr<Handle> handle) noexcept : handle_(std::move(handle)) {}
Chip::Chip(Chip&&) noexcept = default;
Chip::~Chip() = default;

std::string Chip::label() const { return text(gpiod_chip_label(handle_->chip)); }
unsigned Chip::line_count() const { return gpiod_chip_num_lines(handle_->chip); }

std::optional<unsigned> Chip::find(const std::string& name) const {
  gpiod_line* const line = gpiod_chip_find_line(handle_->chip, name.c_str());
  return line == nullptr ? std::nullopt : std::optional(gpiod_line_offset(line));
}

std::string Chip::name_of(unsigned line) const {
  gpiod_line* const found = gpiod_chip_get_line(handle_->chip, line);
  return found == nullptr ? std::string() : text(gpiod_line_name(found));
}

std::string Chip::consumer_of(unsigned line) const {
  gpiod_line* const found = gpiod_chip_get_line(handle_->chip, line);
  return found == nullptr ? std::string() : text(gpiod_line_consumer(found));
}

std::optional<Request> Chip::request_outputs(std::span<const unsigned> lines, unsigned values) {
  auto request = std::make_unique<Request::Handle>(handle_);
  std::array<int, most_lines> levels{};
  for (std::size_t i = 0; i < lines.size(); ++i) {
    gpiod_line* const line = gpiod_chip_get_line(handle_->chip, lines[i]);
    if (line == nullptr) return std::nullopt;
    gpiod_line_bulk_add(&request->lines, line);
    levels.at(i) = static_cast<int>(values >> i & 1U);
  }
  if (gpiod_line_request_bulk_output(&request->lines, consumer, levels.data()) != 0) return std::nullopt;
  request->held = true;
  return Request(std::move(request));
}

std::optional<Request> Chip::request_edges(unsigned line) {
  auto request = std::make_unique<Request::Handle>(handle_);
  gpiod_line* const watched = gpiod_chip_get_line(handle_->chip, line);
  if (watched == nullptr) return std::nullopt;
  gpiod_line_bulk_add(&request->lines, watched);
  if (gpiod_line_request_rising_edge_events(watched, consumer) != 0) return std::nullopt;
  request->held = true;
  return Request(std::move(request));
}

Request::Request(std::unique_ptr<Handle> handle) noexcept : handle_(std::move(handle)) {}
Request::Request(Request&&) noexcept = default;
Request::~Request() = default;

bool Request::set(unsigned values) noexcept {
  std::array<int, most_lines> levels{};
  for (unsigned i = 0; i < handle_->lines.num_lines; ++i) levels[i] = static_cast<int>(values >> i & 1U);
  return gpiod_line_set_value_bulk(&handle_->lines, levels.data()) == 0;
}

int Request::wait(std::int64_t nanoseconds) noexcept {
  const timespec most{static_cast<time_t>(nanoseconds / second), static_cast<long>(nanoseconds % second)};
  return gpiod_line_event_wait(handle_->lines.lines[0], &most);
}

int Request::read(std::span<Nanoseconds, queued_edges> times) noexcept {
  std::array<gpiod_line_event, queued_edges> events{};
  const int count = gpiod_line_event_read_multiple(handle_->lines.lines[0], events.data(), queued_edges);
  for (int i = 0; i < count; ++i) {
    const timespec& at = events[static_cast<std::size_t>(i)].ts;
    times[static_cast<std::size_t>(i)] =
        static_cast<Nanoseconds>(at.tv_sec) * second + static_cast<Nanoseconds>(at.tv_nsec);
  }
  return count;
}

}  // namespace hal::linux_io::gpiod
