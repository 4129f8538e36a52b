// SPDX-License-Identifier: MIT
#include <hal/sim/panel.hpp>
#include <hal/sim/pixels.hpp>

#include <algorithm>
#include <utility>

namespace hal::sim {

Panel::Panel(PanelSpec spec, VirtualClock& clock)
    : spec_(std::move(spec)), clock_(&clock), start_(clock.now()) {
  Capabilities& c = spec_.capabilities;
  c.fixed_palette = spec_.fixed_colours;
  spec_.total_lines = std::max(spec_.total_lines, c.height + 1);
  const std::uint64_t lines_in_1000_s =
      static_cast<std::uint64_t>(c.refresh_millihertz) * static_cast<std::uint64_t>(spec_.total_lines);
  line_time_ = (1'000'000'000'000U + lines_in_1000_s / 2U) / lines_in_1000_s;
  stride_ = row_bytes(c.width, c.bits_per_pixel) + spec_.row_padding;
  const auto bytes = static_cast<std::size_t>(stride_) * static_cast<std::size_t>(c.height);
  buffers_.assign(static_cast<std::size_t>(std::max(c.buffers, 1)), std::vector<std::uint8_t>(bytes));
  palette_ = spec_.fixed_colours;
  if (c.palette_entries > 0) palette_.assign(static_cast<std::size_t>(c.palette_entries) * 3U, 0);
  clock_->attach(*this);
}

Panel::~Panel() { clock_->detach(*this); }

void Panel::attach(Observer& observer) {
  if (observers_.empty()) {
    // No line was scanned while no one looked: go on from where the beam is now.
    const Nanoseconds now = clock_->now();
    const Nanoseconds begin = refresh_start();
    const Nanoseconds passed = now > begin ? (now - begin + line_time_ - 1) / line_time_ : 0;
    line_ = static_cast<int>(std::min(passed, height()));
  }
  observers_.push_back(&observer);
  tell_presented(displayed_, displayed_frame_, palette_);
}

void Panel::detach(Observer& observer) { std::erase(observers_, &observer); }

std::span<const std::uint8_t> Panel::row(int y) const {
  const Capabilities& c = spec_.capabilities;
  const auto first = static_cast<std::size_t>(y) * static_cast<std::size_t>(stride_);
  return std::span(buffers_[static_cast<std::size_t>(displayed_)])
      .subspan(first, static_cast<std::size_t>(row_bytes(c.width, c.bits_per_pixel)));
}

Picture Panel::displayed() const {
  const Capabilities& c = spec_.capabilities;
  Picture picture{c.width, c.height, {}, {}};
  for (int y = 0; y < c.height; ++y)
    for (int x = 0; x < c.width; ++x)
      picture.indices.push_back(pixel_at(row(y), x, c.bits_per_pixel, c.bit_order));
  const auto kept = static_cast<std::uint8_t>(c.palette_entries == 0 ? 0xFF : 0xFF00 >> c.palette_bits);
  for (const std::uint8_t index : picture.indices)
    for (std::size_t channel = 0; channel < 3; ++channel) {
      const std::size_t place = std::size_t{index} * 3U + channel;
      // An index beyond a short palette is black.
      picture.rgb.push_back(place < palette_.size() ? palette_[place] & kept : std::uint8_t{0});
    }
  return picture;
}

std::span<std::uint8_t> Panel::do_buffer(int index) noexcept {
  return buffers_[static_cast<std::size_t>(index)];
}

Status Panel::do_show(int index, std::span<const std::uint8_t> palette) noexcept {
  Request request{index, ++presented_, pending_ ? pending_->palette : palette_};
  std::copy(palette.begin(), palette.end(), request.palette.begin());
  tell_presented(index, request.frame, request.palette);
  pending_ = std::move(request);
  if (spec_.latch == Latch::at_once) take_effect();
  return {};
}

Status Panel::do_write(const Rect& area, std::span<const std::uint8_t> pixels, int stride) noexcept {
  const Capabilities& c = spec_.capabilities;
  for (int y = 0; y < area.height; ++y) {
    const auto from = pixels.subspan(static_cast<std::size_t>(y) * static_cast<std::size_t>(stride));
    const auto to = std::span(buffers_[0])
                        .subspan(static_cast<std::size_t>(area.y + y) * static_cast<std::size_t>(stride_));
    for (int x = 0; x < area.width; ++x)
      set_pixel(to, area.x + x, c.bits_per_pixel, c.bit_order,
                pixel_at(from, x, c.bits_per_pixel, c.bit_order));
  }
  return {};
}

Status Panel::do_load_palette(std::span<const std::uint8_t> palette) noexcept {
  std::copy(palette.begin(), palette.end(), palette_.begin());
  tell_presented(displayed_, displayed_frame_, palette_);
  return {};
}

Status Panel::do_wait_for_vblank() noexcept {
  clock_->wait_until(vblank_time());
  return {};
}

void Panel::before_time_moves(Nanoseconds time) {
  for (;;) {
    if (observers_.empty()) line_ = spec_.capabilities.height;
    if (refresh_start() + static_cast<Nanoseconds>(line_) * line_time_ > time) return;
    if (line_ < spec_.capabilities.height) {
      scan_line();
    } else {
      begin_vblank();
    }
  }
}

void Panel::scan_line() {
  const ScannedLine line{refresh_, line_, refresh_start() + static_cast<Nanoseconds>(line_) * line_time_,
                         row(line_), palette_};
  for (Observer* const observer : observers_) observer->on_line(line);
  ++line_;
}

void Panel::begin_vblank() {
  const Nanoseconds time = vblank_time();
  if (pending_) take_effect();
  for (Observer* const observer : observers_) observer->on_vblank(refresh_, time);
  ++refresh_;
  line_ = 0;
}

void Panel::take_effect() {
  displayed_ = pending_->buffer;
  displayed_frame_ = pending_->frame;
  palette_ = std::move(pending_->palette);
  pending_.reset();
}

void Panel::tell_presented(int buffer, std::uint32_t frame, std::span<const std::uint8_t> palette) const {
  for (Observer* const observer : observers_)
    observer->on_presented({frame, buffers_[static_cast<std::size_t>(buffer)], stride_, palette});
}

}  // namespace hal::sim
