// SPDX-License-Identifier: MIT
//
// The functions of libgpiod 1 that are used, over a kernel that isn't there.
#include "../fake_gpio.hpp"

#include <algorithm>
#include <cerrno>
#include <gpiod.h>
#include <memory>

struct gpiod_line {
  gpiod_chip* chip;
  unsigned number;
};

struct gpiod_chip {
  fake_gpio::Chip* chip;
  std::vector<std::unique_ptr<gpiod_line>> lines;
};

namespace {

fake_gpio::Line& state(gpiod_line* line) { return line->chip->chip->lines.at(line->number); }
const char* or_null(const std::string& text) { return text.empty() ? nullptr : text.c_str(); }

}  // namespace

extern "C" {

gpiod_chip* gpiod_chip_open(const char* path) {
  fake_gpio::Chip* const chip = fake_gpio::kernel().open_chip(path);
  if (chip == nullptr) return nullptr;
  auto* const opened = new gpiod_chip{chip, {}};
  for (unsigned i = 0; i < chip->lines.size(); ++i)
    opened->lines.push_back(std::make_unique<gpiod_line>(gpiod_line{opened, i}));
  return opened;
}

void gpiod_chip_close(gpiod_chip* chip) {
  --fake_gpio::kernel().open;
  delete chip;
}

const char* gpiod_chip_label(gpiod_chip* chip) { return chip->chip->label.c_str(); }
unsigned gpiod_chip_num_lines(gpiod_chip* chip) { return static_cast<unsigned>(chip->lines.size()); }

gpiod_line* gpiod_chip_get_line(gpiod_chip* chip, unsigned number) {
  if (number < chip->lines.size()) return chip->lines[number].get();
  errno = EINVAL;
  return nullptr;
}

gpiod_line* gpiod_chip_find_line(gpiod_chip* chip, const char* name) {
  const auto found =
      std::ranges::find_if(chip->lines, [&](const auto& line) { return state(line.get()).name == name; });
  if (found != chip->lines.end()) return found->get();
  errno = ENOENT;
  return nullptr;
}

unsigned gpiod_line_offset(gpiod_line* line) { return line->number; }
const char* gpiod_line_name(gpiod_line* line) { return or_null(state(line).name); }
const char* gpiod_line_consumer(gpiod_line* line) { return or_null(state(line).consumer); }

int gpiod_line_request_bulk_output(gpiod_line_bulk* bulk, const char* consumer, const int* values) {
  std::vector<unsigned> taken;
  fake_gpio::Kernel& kernel = fake_gpio::kernel();
  fake_gpio::Chip& chip = *bulk->lines[0]->chip->chip;
  for (unsigned i = 0; i < bulk->num_lines; ++i) {
    if (!kernel.take(chip, bulk->lines[i]->number, consumer)) {
      const int error = errno;
      for (const unsigned line : taken) kernel.give(chip, line);
      errno = error;
      return -1;
    }
    taken.push_back(bulk->lines[i]->number);
  }
  return kernel.set(chip, taken, values) ? 0 : -1;
}

int gpiod_line_request_rising_edge_events(gpiod_line* line, const char* consumer) {
  fake_gpio::kernel().overflow = fake_gpio::Overflow::drops_newest;
  return fake_gpio::kernel().take(*line->chip->chip, line->number, consumer) ? 0 : -1;
}

void gpiod_line_release_bulk(gpiod_line_bulk* bulk) {
  for (unsigned i = 0; i < bulk->num_lines; ++i)
    fake_gpio::kernel().give(*bulk->lines[i]->chip->chip, bulk->lines[i]->number);
}

int gpiod_line_set_value_bulk(gpiod_line_bulk* bulk, const int* values) {
  std::vector<unsigned> lines;
  for (unsigned i = 0; i < bulk->num_lines; ++i) lines.push_back(bulk->lines[i]->number);
  return fake_gpio::kernel().set(*bulk->lines[0]->chip->chip, lines, values) ? 0 : -1;
}

int gpiod_line_event_wait(gpiod_line*, const timespec* timeout) {
  return fake_gpio::kernel().wait(static_cast<hal::Nanoseconds>(timeout->tv_sec) * 1'000'000'000U +
                                  static_cast<hal::Nanoseconds>(timeout->tv_nsec));
}

int gpiod_line_event_read_multiple(gpiod_line*, gpiod_line_event* events, unsigned most) {
  std::vector<hal::Nanoseconds> times(most);
  const int count = fake_gpio::kernel().read(times.data(), static_cast<int>(most));
  for (int i = 0; i < count; ++i) {
    const hal::Nanoseconds time = times[static_cast<std::size_t>(i)];
    events[i].ts = {static_cast<time_t>(time / 1'000'000'000U), static_cast<long>(time % 1'000'000'000U)};
    events[i].event_type = GPIOD_LINE_EVENT_RISING_EDGE;
  }
  return count;
}

}  // extern "C"
