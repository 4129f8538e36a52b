// SPDX-License-Identifier: MIT
//
// libgpiod 2.x.
#include <hal/linux/gpiod.hpp>
#include <hal/linux/owned.hpp>

#include <array>
#include <cerrno>
#include <gpiod.h>

namespace hal::linux_io::gpiod {

namespace {

using LineInfo = Owned<gpiod_line_info, gpiod_line_info_free>;
using ChipInfo = Owned<gpiod_chip_info, gpiod_chip_info_free>;
using Settings = Owned<gpiod_line_settings, gpiod_line_settings_free>;
using LineConfig = Owned<gpiod_line_config, gpiod_line_config_free>;
using RequestConfig = Owned<gpiod_request_config, gpiod_request_config_free>;
using Lines = Owned<gpiod_line_request, gpiod_line_request_release>;
using EventBuffer = Owned<gpiod_edge_event_buffer, gpiod_edge_event_buffer_free>;

std::string text(const char* words) { return words == nullptr ? std::string() : std::string(words); }

gpiod_line_value value_of(unsigned values, std::size_t line) {
  return (values >> line & 1U) != 0 ? GPIOD_LINE_VALUE_ACTIVE : GPIOD_LINE_VALUE_INACTIVE;
}

/// Holds what `config` describes. Null: errno.
Lines request_lines(gpiod_chip* chip, gpiod_line_config* config) {
  const RequestConfig about(gpiod_request_config_new());
  if (about == nullptr) return nullptr;
  gpiod_request_config_set_consumer(about.get(), consumer);
  gpiod_request_config_set_event_buffer_size(about.get(), queued_edges);
  return Lines(gpiod_chip_request_lines(chip, about.get(), config));
}

}  // namespace

struct Chip::Handle {
  Owned<gpiod_chip, gpiod_chip_close> chip;
};

struct Request::Handle {
  Lines lines;
  std::size_t count = 0;
  EventBuffer events;
};

std::optional<Chip> Chip::open(const std::string& path) {
  auto handle = std::make_unique<Handle>();
  handle->chip.reset(gpiod_chip_open(path.c_str()));
  if (handle->chip == nullptr) return std::nullopt;
  return Chip(std::move(handle));
}

Chip::Chip(std::unique_ptr<Handle> handle) noexcept : handle_(std::move(handle)) {}
Chip::Chip(Chip&&) noexcept = default;
Chip::~Chip() = default;

std::string Chip::label() const {
  const ChipInfo info(gpiod_chip_get_info(handle_->chip.get()));
  return info == nullptr ? std::string() : text(gpiod_chip_info_get_label(info.get()));
}

unsigned Chip::line_count() const {
  const ChipInfo info(gpiod_chip_get_info(handle_->chip.get()));
  return info == nullptr ? 0U : static_cast<unsigned>(gpiod_chip_info_get_num_lines(info.get()));
}

std::optional<unsigned> Chip::find(const std::string& name) const {
  const int line = gpiod_chip_get_line_offset_from_name(handle_->chip.get(), name.c_str());
  return line < 0 ? std::nullopt : std::optional(static_cast<unsigned>(line));
}

std::string Chip::name_of(unsigned line) const {
  const LineInfo info(gpiod_chip_get_line_info(handle_->chip.get(), line));
  return info == nullptr ? std::string() : text(gpiod_line_info_get_name(info.get()));
}

std::string Chip::consumer_of(unsigned line) const {
  const LineInfo info(gpiod_chip_get_line_info(handle_->chip.get(), line));
  return info == nullptr ? std::string() : text(gpiod_line_info_get_consumer(info.get()));
}

std::optional<Request> Chip::request_outputs(std::span<const unsigned> lines, unsigned values) {
  const Settings settings(gpiod_line_settings_new());
  const LineConfig config(gpiod_line_config_new());
  if (settings == nullptr || config == nullptr) return std::nullopt;
  if (gpiod_line_settings_set_direction(settings.get(), GPIOD_LINE_DIRECTION_OUTPUT) != 0)
    return std::nullopt;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (gpiod_line_settings_set_output_value(settings.get(), value_of(values, i)) != 0) return std::nullopt;
    if (gpiod_line_config_add_line_settings(config.get(), &lines[i], 1, settings.get()) != 0)
      return std::nullopt;
  }
  auto request = std::make_unique<Request::Handle>();
  request->count = lines.size();
  request->lines = request_lines(handle_->chip.get(), config.get());
  if (request->lines == nullptr) return std::nullopt;
  return Request(std::move(request));
}

std::optional<Request> Chip::request_edges(unsigned line) {
  const Settings settings(gpiod_line_settings_new());
  const LineConfig config(gpiod_line_config_new());
  if (settings == nullptr || config == nullptr) return std::nullopt;
  if (gpiod_line_settings_set_direction(settings.get(), GPIOD_LINE_DIRECTION_INPUT) != 0 ||
      gpiod_line_settings_set_edge_detection(settings.get(), GPIOD_LINE_EDGE_RISING) != 0 ||
      gpiod_line_settings_set_event_clock(settings.get(), GPIOD_LINE_CLOCK_MONOTONIC) != 0 ||
      gpiod_line_config_add_line_settings(config.get(), &line, 1, settings.get()) != 0)
    return std::nullopt;
  auto request = std::make_unique<Request::Handle>();
  request->count = 1;
  request->events.reset(gpiod_edge_event_buffer_new(queued_edges));
  if (request->events == nullptr) return std::nullopt;
  request->lines = request_lines(handle_->chip.get(), config.get());
  if (request->lines == nullptr) return std::nullopt;
  return Request(std::move(request));
}

Request::Request(std::unique_ptr<Handle> handle) noexcept : handle_(std::move(handle)) {}
Request::Request(Request&&) noexcept = default;
Request::~Request() = default;

bool Request::set(unsigned values) noexcept {
  std::array<gpiod_line_value, most_lines> levels{};
  for (std::size_t i = 0; i < handle_->count; ++i) levels[i] = value_of(values, i);
  return gpiod_line_request_set_values(handle_->lines.get(), levels.data()) == 0;
}

int Request::wait(std::int64_t nanoseconds) noexcept {
  return gpiod_line_request_wait_edge_events(handle_->lines.get(), nanoseconds);
}

int Request::read(std::span<Nanoseconds, queued_edges> times) noexcept {
  const int count =
      gpiod_line_request_read_edge_events(handle_->lines.get(), handle_->events.get(), queued_edges);
  for (int i = 0; i < count; ++i) {
    gpiod_edge_event* const event =
        gpiod_edge_event_buffer_get_event(handle_->events.get(), static_cast<unsigned long>(i));
    times[static_cast<std::size_t>(i)] = gpiod_edge_event_get_timestamp_ns(event);
  }
  return count;
}

}  // namespace hal::linux_io::gpiod
