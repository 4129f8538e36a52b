// SPDX-License-Identifier: MIT
#include <hal/hid/crc32.hpp>
#include <hal/hid/host/panel.hpp>
#include <hal/hid/host/patience.hpp>
#include <hal/hid/run_length.hpp>

#include <algorithm>

namespace hal::hid {

namespace {

/// A frame may be refused after a fault of the device's memory, and the device may go away in mid-frame; a
/// device that refuses whole frames, or keeps going away, is broken.
constexpr int attempts = 8;

}  // namespace

HidPanel::HidPanel(Link& link, const HidPanelOptions& options)
    : link_(&link),
      options_(options),
      capabilities_(link.info().capabilities),
      row_bytes_(row_bytes(capabilities_.width, capabilities_.bits_per_pixel)),
      palette_(static_cast<std::size_t>(capabilities_.palette_entries) * 3U) {
  capabilities_.buffers = static_cast<int>(buffers_.size());
  for (auto& buffer : buffers_) buffer.resize(picture_bytes(capabilities_));
  held_.resize(picture_bytes(capabilities_));
  held_palette_.resize(palette_.size());
}

Status HidPanel::note(const Status& status) {
  if (status.error() == Error::disconnected && connected_) {
    vblanks_before_ += link_->state().vblanks;
    connected_ = false;
    known_ = false;
    committed_ = 0;
  }
  return status;
}

Status HidPanel::reconnect() {
  const Status s = look_for_device(link_->clock(), options_.replug_patience,
                                   [this] { return link_->lost() ? link_->renew() : link_->reopen(); });
  if (!s.ok()) return s;
  ++counters_.reconnects;
  connected_ = true;
  return {};
}

Status HidPanel::do_show(int index, std::span<const std::uint8_t> palette) noexcept {
  std::copy(palette.begin(), palette.end(), palette_.begin());
  return present(buffers_[static_cast<std::size_t>(index)]);
}

Status HidPanel::do_load_palette(std::span<const std::uint8_t> palette) noexcept {
  std::copy(palette.begin(), palette.end(), palette_.begin());
  // A copy: what is sent becomes what is held.
  const std::vector<std::uint8_t> same = held_;
  return known_ ? present(same) : Status{};
}

Status HidPanel::present(std::span<const std::uint8_t> picture) {
  for (int attempt = 0; attempt < attempts; ++attempt) {
    if (!connected_)
      if (const Status s = reconnect(); !s.ok()) return s;
    const bool whole = !known_;
    const Status s = note(send_frame(picture));
    if (s.error() == Error::disconnected) {
      if (options_.replug_patience != 0 || link_->lost()) continue;
      return s;
    }
    if (!s.ok()) {
      known_ = false;
      return s;
    }
    const DeviceState& state = link_->state();
    if (state.decided == frame_ && state.verdict == Verdict::accepted) {
      ++counters_.frames;
      if (whole) ++counters_.whole;
      std::copy(picture.begin(), picture.end(), held_.begin());
      held_palette_ = palette_;
      known_ = shown_before_ = true;
      committed_ = frame_;
      return {};
    }
    ++counters_.rejected;
    known_ = false;
  }
  return {connected_ ? Error::bus : Error::disconnected, Part::panel};
}

Rect HidPanel::difference(std::span<const std::uint8_t> picture) const {
  const Capabilities& c = capabilities_;
  if (!known_) return {0, 0, c.width, c.height};
  int top = c.height;
  int bottom = 0;
  std::size_t left = row_bytes_;
  std::size_t right = 0;
  for (int y = 0; y < c.height; ++y) {
    const std::size_t at = static_cast<std::size_t>(y) * row_bytes_;
    const auto fresh = picture.subspan(at, row_bytes_);
    const auto before = std::span(held_).subspan(at, row_bytes_);
    const auto first = std::mismatch(fresh.begin(), fresh.end(), before.begin()).first;
    if (first == fresh.end()) continue;
    std::size_t end = row_bytes_;
    while (fresh[end - 1] == before[end - 1]) --end;
    left = std::min(left, static_cast<std::size_t>(first - fresh.begin()));
    right = std::max(right, end);
    top = std::min(top, y);
    bottom = y + 1;
  }
  if (right == 0) return {};
  const int a_byte = 8 / c.bits_per_pixel;
  const int x = static_cast<int>(left) * a_byte;
  return {x, top, std::min(static_cast<int>(right) * a_byte, c.width) - x, bottom - top};
}

Status HidPanel::send_frame(std::span<const std::uint8_t> picture) {
  frame_ = static_cast<std::uint16_t>(frame_ == 0xFFFFU ? 1U : frame_ + 1U);
  if (const Status s = send_palette(); !s.ok()) return s;
  if (const Rect area = difference(picture); area.width != 0)
    if (const Status s = send_rect(area, picture); !s.ok()) return s;
  Crc32 crc;
  crc.add(palette_);
  crc.add(picture);
  if (const Status s = link_->transmit(ReportType::commit, encode(Commit{frame_, crc.value()})); !s.ok())
    return s;
  return link_->settle();
}

Status HidPanel::send_palette() {
  std::size_t first = 0;
  std::size_t end = palette_.size();
  if (known_) {
    while (first < end && palette_[first] == held_palette_[first]) ++first;
    while (end > first && palette_[end - 1] == held_palette_[end - 1]) --end;
    first -= first % 3U;
    end = (end + 2U) / 3U * 3U;
  }
  std::vector<std::uint8_t> payload;
  while (first < end) {
    const auto most = static_cast<std::size_t>(palette_entries_in(link_->room() + header_bytes)) * 3U;
    const std::size_t count = std::min(most, end - first);
    payload.assign(1, static_cast<std::uint8_t>(first / 3U));
    payload.insert(payload.end(), palette_.begin() + static_cast<std::ptrdiff_t>(first),
                   palette_.begin() + static_cast<std::ptrdiff_t>(first + count));
    if (const Status s = link_->transmit(ReportType::palette, payload); !s.ok()) return s;
    first += count;
  }
  return {};
}

Status HidPanel::send_rect(const Rect& area, std::span<const std::uint8_t> picture) {
  const std::size_t across = row_bytes(area.width, capabilities_.bits_per_pixel);
  const std::size_t left = row_bytes(area.x, capabilities_.bits_per_pixel);
  std::vector<std::uint8_t> fresh;
  std::vector<std::uint8_t> before;
  for (int y = area.y; y < area.y + area.height; ++y) {
    const std::size_t at = static_cast<std::size_t>(y) * row_bytes_ + left;
    const auto line = picture.subspan(at, across);
    fresh.insert(fresh.end(), line.begin(), line.end());
    if (!known_) continue;
    const auto held = std::span(held_).subspan(at, across);
    before.insert(before.end(), held.begin(), held.end());
  }
  const auto head = encode(area);
  std::vector<std::uint8_t> payload(link_->room());
  std::copy(head.begin(), head.end(), payload.begin());
  std::size_t used = head.size();
  ReportType type = ReportType::rectangle;
  for (std::size_t taken = 0; taken < fresh.size();) {
    const auto old =
        known_ ? std::span<const std::uint8_t>(before).subspan(taken) : std::span<const std::uint8_t>{};
    const Packed packed = pack(std::span(fresh).subspan(taken), old, std::span(payload).subspan(used));
    const Status s = link_->transmit(type, std::span(payload).first(used + packed.written));
    if (!s.ok()) return s;
    taken += packed.taken;
    used = 0;
    type = ReportType::pixels;
  }
  return {};
}

bool HidPanel::do_show_pending() noexcept {
  if (!connected_ || !pending()) return false;
  note(link_->drain()).ignore();
  return connected_ && pending();
}

std::uint32_t HidPanel::do_vblank_count() noexcept {
  if (!connected_) return vblanks_before_;
  note(link_->drain()).ignore();
  return connected_ ? vblanks_before_ + link_->state().vblanks : vblanks_before_;
}

Nanoseconds HidPanel::vblank_patience() const {
  // As many frames as a device may miss before it counts as stuck, but no less than the link waits.
  constexpr Nanoseconds frames = 8;
  return std::max(frames * period(), link_->patience());
}

Nanoseconds HidPanel::next_vblank() const {
  const Nanoseconds due = link_->vblank_told_at() + period() + link_->answer_time();
  const Nanoseconds now = link_->clock().now();
  return due > now ? due - now : 0;
}

Status HidPanel::recover() {
  if (link_->lost()) note({Error::disconnected, Part::panel}).ignore();
  if (options_.replug_patience == 0 && !link_->lost()) return {Error::disconnected, Part::panel};
  // A copy: what is sent becomes what is held.
  const std::vector<std::uint8_t> same = held_;
  return shown_before_ ? present(same) : reconnect();
}

Status HidPanel::do_wait_for_vblank() noexcept {
  if (connected_) note(link_->drain()).ignore();
  // A device that comes and goes is waited for as often as its picture is sent again.
  for (int returns = 0; returns < attempts; ++returns) {
    if (!connected_ || link_->lost())
      if (const Status s = recover(); !s.ok()) return s;
    const std::uint32_t before = link_->state().vblanks;
    constexpr Nanoseconds chance = 20'000'000;
    Patience patience(link_->clock(), vblank_patience());
    bool prompted = false;
    while (connected_ && !link_->lost() && (link_->state().vblanks == before || pending())) {
      if (patience.over()) return {Error::timeout, Part::panel};
      const Nanoseconds left = patience.left(chance);
      const Status s = note(link_->listen(prompted ? left : std::min(left, next_vblank())));
      if (!s.ok() && s.error() != Error::timeout && s.error() != Error::disconnected) return s;
      // What the device said of it was lost: it is asked, once.
      if (!prompted && next_vblank() == 0) {
        prompted = true;
        note(link_->prompt()).ignore();
      }
    }
    if (connected_ && !link_->lost()) return {};
  }
  return {Error::disconnected, Part::panel};
}

Keys HidInput::do_poll() noexcept {
  Keys keys;
  // Nobody holds the keys of a device that is gone.
  if (!link_->drain().ok()) return keys;
  for (unsigned key = 0; key <= static_cast<unsigned>(Key::back); ++key)
    if ((static_cast<unsigned>(link_->state().keys) >> key & 1U) != 0) keys.press(static_cast<Key>(key));
  return keys;
}

}  // namespace hal::hid
