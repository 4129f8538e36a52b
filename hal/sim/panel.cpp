// SPDX-License-Identifier: MIT
#include <hal/sim/effects/drift.hpp>
#include <hal/sim/effects/garbage.hpp>
#include <hal/sim/effects/scan.hpp>
#include <hal/sim/panel.hpp>
#include <hal/sim/pixels.hpp>

#include <algorithm>
#include <utility>

namespace hal::sim {

Panel::Panel(PanelSpec spec, VirtualClock& clock, const Effects& effects)
    : spec_(std::move(spec)), clock_(&clock), drift_(effects.drift) {
  Capabilities& c = spec_.capabilities;
  c.refresh_millihertz = std::max(c.refresh_millihertz, 1U);
  c.fixed_palette = spec_.fixed_colours;
  if (effects.scan) c.scan = *effects.scan;
  if (effects.bus) bus_.emplace(*effects.bus, c);
  if (effects.te) te_.emplace(*effects.te, clock, c.refresh_millihertz);
  if (effects.latch) palette_latch_ = *effects.latch;
  if (palette_latch_ == PaletteLatch::both_at_once) spec_.latch = Latch::at_once;
  set_times();
  // Beside a program's own clock what is rounded off each line would add up to whole refreshes.
  if (effects.te) {
    const std::uint32_t rate = effects.te->millihertz > 0 ? effects.te->millihertz : c.refresh_millihertz;
    nominal_frame_time_ = (1'000'000'000'000U + rate / 2U) / rate;
  }
  stride_ = row_bytes(c.width, c.bits_per_pixel) + spec_.row_padding;
  const auto bytes = static_cast<std::size_t>(stride_) * static_cast<std::size_t>(c.height);
  buffers_.assign(static_cast<std::size_t>(std::max(c.buffers, 1)), std::vector<std::uint8_t>(bytes));
  if (c.palette_on_write)
    colours_.resize(3U * static_cast<std::size_t>(c.width) * static_cast<std::size_t>(c.height));
  palette_ = spec_.fixed_colours;
  if (c.palette_entries > 0) palette_.assign(static_cast<std::size_t>(c.palette_entries) * 3U, 0);
  if (effects.garbage) {
    for (std::size_t i = 0; i < buffers_.size(); ++i) fill_with_garbage(*effects.garbage, i, buffers_[i]);
    if (c.palette_entries > 0) fill_with_garbage(*effects.garbage, buffers_.size(), palette_);
    fill_with_garbage(*effects.garbage, buffers_.size() + 1U, colours_);
  }
  begin_refresh(static_cast<Clock&>(clock).now());
  clock_->attach(*this);
}

void Panel::set_times() {
  const Capabilities& c = spec_.capabilities;
  spec_.total_lines = std::max(spec_.total_lines, c.height + 1);
  lines_ = lines_of(c);
  // The same share of blanking, whichever way the beam goes.
  if (by_columns(c.scan)) spec_.total_lines = std::max(spec_.total_lines * c.width / c.height, lines_ + 1);
  const std::uint64_t lines_in_1000_s =
      static_cast<std::uint64_t>(c.refresh_millihertz) * static_cast<std::uint64_t>(spec_.total_lines);
  const Nanoseconds line_time = (1'000'000'000'000U + lines_in_1000_s / 2U) / lines_in_1000_s;
  nominal_frame_time_ = line_time * static_cast<Nanoseconds>(spec_.total_lines);
}

void Panel::begin_refresh(Nanoseconds time) {
  refresh_start_ = time;
  frame_time_ = drift_ ? drifting_frame_time(*drift_, nominal_frame_time_, time) : nominal_frame_time_;
}

Panel::~Panel() { clock_->detach(*this); }

void Panel::attach(Observer& observer) {
  if (observers_.empty()) {
    // No line was scanned while no one looked: go on from where the beam is now.
    const Nanoseconds now = static_cast<Clock*>(clock_)->now();
    line_ = 0;
    while (line_ < lines_ && time_of(line_) < now) ++line_;
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

std::span<const std::uint8_t> Panel::memory(int buffer) const {
  return colours_.empty() ? buffers_[static_cast<std::size_t>(buffer)] : colours_;
}

Picture Panel::displayed() const {
  const Capabilities& c = spec_.capabilities;
  Picture picture{c.width, c.height, {}, {}};
  for (int y = 0; y < c.height; ++y)
    for (int x = 0; x < c.width; ++x)
      picture.indices.push_back(pixel_at(row(y), x, c.bits_per_pixel, c.bit_order));
  picture.rgb = colours_;
  if (!colours_.empty()) return picture;
  for (const std::uint8_t index : picture.indices)
    for (std::size_t channel = 0; channel < 3; ++channel)
      picture.rgb.push_back(colour(palette_, index, channel));
  return picture;
}

std::uint8_t Panel::colour(std::span<const std::uint8_t> palette, std::size_t index,
                           std::size_t channel) const {
  const Capabilities& c = spec_.capabilities;
  const std::size_t place = index * 3U + channel;
  if (place >= palette.size()) return 0;
  const int kept = c.palette_entries == 0 ? 0xFF : 0xFF00 >> c.palette_bits;
  return static_cast<std::uint8_t>(palette[place] & kept);
}

std::span<std::uint8_t> Panel::do_buffer(int index) noexcept {
  return buffers_[static_cast<std::size_t>(index)];
}

Status Panel::do_show(int index, std::span<const std::uint8_t> palette) noexcept {
  const Nanoseconds now = static_cast<Clock*>(clock_)->now();
  if (pending_)
    for (Observer* const observer : observers_) observer->on_dropped(pending_->frame, now);
  replaced_ = pending_.has_value();
  Request request{index, ++presented_, pending_ ? pending_->palette : palette_};
  std::copy(palette.begin(), palette.end(), request.palette.begin());
  tell_presented(index, request.frame, request.palette);
  if (palette_latch_ != PaletteLatch::at_vblank) {
    note_call(Effect::latch);
    palette_ = request.palette;
  }
  pending_ = std::move(request);
  if (spec_.latch == Latch::at_once) take_effect(now);
  return {};
}

Status Panel::do_write(const Rect& area, std::span<const std::uint8_t> pixels, int stride) noexcept {
  const Capabilities& c = spec_.capabilities;
  const auto put = [&](int x, int y) {
    const auto from = pixels.subspan(static_cast<std::size_t>(y) * static_cast<std::size_t>(stride));
    const auto to = std::span(buffers_[0])
                        .subspan(static_cast<std::size_t>(area.y + y) * static_cast<std::size_t>(stride_));
    const std::uint8_t index = pixel_at(from, x, c.bits_per_pixel, c.bit_order);
    set_pixel(to, area.x + x, c.bits_per_pixel, c.bit_order, index);
    if (!c.palette_on_write) return;
    const std::size_t place = static_cast<std::size_t>(area.y + y) * static_cast<std::size_t>(c.width) +
                              static_cast<std::size_t>(area.x + x);
    for (std::size_t channel = 0; channel < 3; ++channel)
      colours_[3U * place + channel] = colour(palette_, index, channel);
  };
  Transfer transfer{static_cast<Clock*>(clock_)->now(), 0, 0, area, do_vblank_count()};
  if (bus_) {
    transfer.bytes = bus_->send(area, *clock_, put);
  } else {
    for (int y = 0; y < area.height; ++y)
      for (int x = 0; x < area.width; ++x) put(x, y);
  }
  tell_transfer(transfer);
  return {};
}

Status Panel::do_load_palette(std::span<const std::uint8_t> palette) noexcept {
  // Colours that are applied to pixels on their way stay in the program's memory.
  if (bus_ && !spec_.capabilities.palette_on_write) {
    Transfer transfer{static_cast<Clock*>(clock_)->now(), 0, 0, {}, do_vblank_count()};
    transfer.bytes = bus_->send_command(1U + palette.size(), *clock_);
    tell_transfer(transfer);
  }
  std::copy(palette.begin(), palette.end(), palette_.begin());
  // Where colours are applied to pixels as they are written, what is shown stays as it is.
  if (!spec_.capabilities.palette_on_write) tell_presented(displayed_, displayed_frame_, palette_);
  return {};
}

void Panel::mark_frame() {
  displayed_frame_ = ++presented_;
  tell_presented(displayed_, displayed_frame_, palette_);
  for (Observer* const observer : observers_)
    observer->on_swap(displayed_frame_, static_cast<Clock*>(clock_)->now());
}

std::uint32_t Panel::do_vblank_count() noexcept {
  if (te_ && !te_->connected()) return te_->ticks().count();
  const bool not_told = te_ && refresh_ > 0 && static_cast<Clock*>(clock_)->now() < last_te_;
  return static_cast<std::uint32_t>(not_told ? refresh_ - 1U : refresh_);
}

Status Panel::do_wait_for_vblank() noexcept {
  if (!te_) {
    clock_->wait_until(time_of(lines_));
  } else if (!te_->connected()) {
    return te_->ticks().wait();
  } else if (refresh_ > 0 && static_cast<Clock*>(clock_)->now() < last_te_) {
    clock_->wait_until(last_te_);
  } else {
    clock_->wait_until(time_of(lines_) + te_->delay(refresh_));
  }
  return {};
}

void Panel::before_time_moves(Nanoseconds time) {
  for (;;) {
    if (observers_.empty()) line_ = lines_;
    if (time_of(line_) > time) return;
    if (line_ < lines_) {
      scan_line();
    } else {
      begin_vblank();
    }
  }
}

void Panel::scan_line() {
  const Capabilities& c = spec_.capabilities;
  const auto pixels = line_pixels(c, memory(displayed_), memory_stride(), line_, column_);
  const ScannedLine line{refresh_,       line_,  place_of(c, line_),
                         time_of(line_), pixels, palette_in_effect(palette_)};
  for (Observer* const observer : observers_) observer->on_line(line);
  ++line_;
}

void Panel::begin_vblank() {
  const Nanoseconds time = time_of(lines_);
  if (pending_) take_effect(time);
  for (Observer* const observer : observers_) observer->on_vblank(refresh_, time);
  if (te_ && te_->connected()) {
    last_te_ = time + te_->delay(refresh_);
    for (Observer* const observer : observers_) observer->on_te(refresh_, last_te_);
  }
  ++refresh_;
  line_ = 0;
  begin_refresh(refresh_start_ + frame_time_);
}

void Panel::take_effect(Nanoseconds time) {
  displayed_ = pending_->buffer;
  displayed_frame_ = pending_->frame;
  palette_ = std::move(pending_->palette);
  pending_.reset();
  for (Observer* const observer : observers_) observer->on_swap(displayed_frame_, time);
}

void Panel::tell_presented(int buffer, std::uint32_t frame, std::span<const std::uint8_t> palette) const {
  for (Observer* const observer : observers_)
    observer->on_presented({frame, memory(buffer), memory_stride(), palette_in_effect(palette)});
}

void Panel::tell_transfer(const Transfer& transfer) const {
  Transfer told = transfer;
  told.end = static_cast<Clock*>(clock_)->now();
  for (Observer* const observer : observers_) observer->on_transfer(told);
}

}  // namespace hal::sim
