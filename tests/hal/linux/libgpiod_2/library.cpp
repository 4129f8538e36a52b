// SPDX-License-Identifier: MIT
//
// The functions of libgpiod 2 that are used, over a kernel that isn't there. Objects that aren't given back
// are counted: `fake_gpio::Kernel::open` counts chips, `held` lines.
#include "../fake_gpio.hpp"

#include <algorithm>
#include <cerrno>
#include <gpiod.h>

struct gpiod_chip {
  fake_gpio::Chip* chip;
};
struct gpiod_chip_info {
  fake_gpio::Chip* chip;
};
struct gpiod_line_info {
  fake_gpio::Line line;
};
struct gpiod_line_settings {
  gpiod_line_direction direction = GPIOD_LINE_DIRECTION_AS_IS;
  gpiod_line_edge edge = GPIOD_LINE_EDGE_NONE;
  gpiod_line_value value = GPIOD_LINE_VALUE_INACTIVE;
};
struct gpiod_line_config {
  std::vector<unsigned> lines;
  std::vector<gpiod_line_settings> settings;
};
struct gpiod_request_config {
  std::string consumer;
  std::size_t events = 0;
};
struct gpiod_line_request {
  fake_gpio::Chip* chip;
  std::vector<unsigned> lines;
  bool output;
};
struct gpiod_edge_event {
  std::uint64_t time = 0;
};
struct gpiod_edge_event_buffer {
  std::vector<gpiod_edge_event> events;
};

namespace {
const char* or_null(const std::string& text) { return text.empty() ? nullptr : text.c_str(); }
int refuse() {
  errno = EINVAL;
  return -1;
}
}  // namespace

extern "C" {

gpiod_chip* gpiod_chip_open(const char* path) {
  fake_gpio::Chip* const chip = fake_gpio::kernel().open_chip(path);
  return chip == nullptr ? nullptr : new gpiod_chip{chip};
}
void gpiod_chip_close(gpiod_chip* chip) {
  --fake_gpio::kernel().open;
  delete chip;
}
gpiod_chip_info* gpiod_chip_get_info(gpiod_chip* chip) { return new gpiod_chip_info{chip->chip}; }
void gpiod_chip_info_free(gpiod_chip_info* info) { delete info; }
const char* gpiod_chip_info_get_label(gpiod_chip_info* info) { return info->chip->label.c_str(); }
size_t gpiod_chip_info_get_num_lines(gpiod_chip_info* info) { return info->chip->lines.size(); }

gpiod_line_info* gpiod_chip_get_line_info(gpiod_chip* chip, unsigned line) {
  if (line < chip->chip->lines.size()) return new gpiod_line_info{chip->chip->lines[line]};
  errno = EINVAL;
  return nullptr;
}
void gpiod_line_info_free(gpiod_line_info* info) { delete info; }
const char* gpiod_line_info_get_name(gpiod_line_info* info) { return or_null(info->line.name); }
const char* gpiod_line_info_get_consumer(gpiod_line_info* info) { return or_null(info->line.consumer); }

int gpiod_chip_get_line_offset_from_name(gpiod_chip* chip, const char* name) {
  const auto& lines = chip->chip->lines;
  const auto found = std::ranges::find(lines, name, &fake_gpio::Line::name);
  if (found != lines.end()) return static_cast<int>(found - lines.begin());
  errno = ENOENT;
  return -1;
}

gpiod_line_settings* gpiod_line_settings_new() { return new gpiod_line_settings; }
void gpiod_line_settings_free(gpiod_line_settings* settings) { delete settings; }
int gpiod_line_settings_set_direction(gpiod_line_settings* settings, gpiod_line_direction direction) {
  settings->direction = direction;
  return 0;
}
int gpiod_line_settings_set_edge_detection(gpiod_line_settings* settings, gpiod_line_edge edge) {
  settings->edge = edge;
  return 0;
}
int gpiod_line_settings_set_event_clock(gpiod_line_settings*, gpiod_line_clock clock) {
  return clock == GPIOD_LINE_CLOCK_MONOTONIC ? 0 : refuse();
}
int gpiod_line_settings_set_output_value(gpiod_line_settings* settings, gpiod_line_value value) {
  settings->value = value;
  return 0;
}

gpiod_line_config* gpiod_line_config_new() { return new gpiod_line_config; }
void gpiod_line_config_free(gpiod_line_config* config) { delete config; }
int gpiod_line_config_add_line_settings(gpiod_line_config* config, const unsigned* lines, size_t count,
                                        gpiod_line_settings* settings) {
  for (std::size_t i = 0; i < count; ++i) {
    config->lines.push_back(lines[i]);
    config->settings.push_back(*settings);
  }
  return 0;
}

gpiod_request_config* gpiod_request_config_new() { return new gpiod_request_config; }
void gpiod_request_config_free(gpiod_request_config* config) { delete config; }
void gpiod_request_config_set_consumer(gpiod_request_config* config, const char* consumer) {
  config->consumer = consumer;
}
void gpiod_request_config_set_event_buffer_size(gpiod_request_config* config, size_t size) {
  config->events = size;
}

gpiod_line_request* gpiod_chip_request_lines(gpiod_chip* chip, gpiod_request_config* about,
                                             gpiod_line_config* config) {
  fake_gpio::Kernel& kernel = fake_gpio::kernel();
  if (config->lines.empty()) {
    refuse();
    return nullptr;
  }
  kernel.overflow = fake_gpio::Overflow::drops_oldest;
  const bool output = config->settings[0].direction == GPIOD_LINE_DIRECTION_OUTPUT;
  if (!output && (config->settings[0].edge != GPIOD_LINE_EDGE_RISING || about->events != 16)) {
    refuse();
    return nullptr;
  }
  std::vector<int> values;
  for (std::size_t i = 0; i < config->lines.size(); ++i) {
    values.push_back(config->settings[i].value == GPIOD_LINE_VALUE_ACTIVE ? 1 : 0);
    if (kernel.take(*chip->chip, config->lines[i], about->consumer.c_str())) continue;
    const int error = errno;
    for (std::size_t k = 0; k < i; ++k) kernel.give(*chip->chip, config->lines[k]);
    errno = error;
    return nullptr;
  }
  if (output) kernel.set(*chip->chip, config->lines, values.data());
  return new gpiod_line_request{chip->chip, config->lines, output};
}

void gpiod_line_request_release(gpiod_line_request* request) {
  for (const unsigned line : request->lines) fake_gpio::kernel().give(*request->chip, line);
  delete request;
}

int gpiod_line_request_set_values(gpiod_line_request* request, const gpiod_line_value* values) {
  if (!request->output) return refuse();
  std::vector<int> levels;
  for (std::size_t i = 0; i < request->lines.size(); ++i)
    levels.push_back(values[i] == GPIOD_LINE_VALUE_ACTIVE ? 1 : 0);
  return fake_gpio::kernel().set(*request->chip, request->lines, levels.data()) ? 0 : -1;
}

int gpiod_line_request_wait_edge_events(gpiod_line_request*, int64_t nanoseconds) {
  return fake_gpio::kernel().wait(static_cast<hal::Nanoseconds>(nanoseconds));
}

int gpiod_line_request_read_edge_events(gpiod_line_request*, gpiod_edge_event_buffer* buffer, size_t most) {
  std::vector<hal::Nanoseconds> times(most);
  const int count = fake_gpio::kernel().read(times.data(), static_cast<int>(most));
  buffer->events.clear();
  for (int i = 0; i < count; ++i) buffer->events.push_back({times[static_cast<std::size_t>(i)]});
  return count;
}

uint64_t gpiod_edge_event_get_timestamp_ns(gpiod_edge_event* event) { return event->time; }
gpiod_edge_event_buffer* gpiod_edge_event_buffer_new(size_t) { return new gpiod_edge_event_buffer; }
void gpiod_edge_event_buffer_free(gpiod_edge_event_buffer* buffer) { delete buffer; }
gpiod_edge_event* gpiod_edge_event_buffer_get_event(gpiod_edge_event_buffer* buffer, unsigned long index) {
  return &buffer->events.at(index);
}

}  // extern "C"
