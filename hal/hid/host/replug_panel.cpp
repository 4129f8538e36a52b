// SPDX-License-Identifier: MIT
#include <hal/hid/host/patience.hpp>
#include <hal/hid/host/replug_panel.hpp>
#include <hal/hid/protocol.hpp>

#include <algorithm>
#include <utility>

namespace hal::hid {

namespace {

/// Rectangles of whole bytes only: those can be copied.
Capabilities in_whole_bytes(Capabilities c) {
  const int own = c.x_alignment;
  while (c.x_alignment * c.bits_per_pixel % 8 != 0) c.x_alignment += own;
  return c;
}

}  // namespace

ReplugPanel::ReplugPanel(Panel& inner, ReportPort& port, Clock& clock, Restart restart, Nanoseconds patience)
    : BufferlessPanel(in_whole_bytes(inner.capabilities())),
      inner_(&inner),
      port_(&port),
      clock_(&clock),
      restart_(std::move(restart)),
      patience_(patience),
      stride_(static_cast<int>(row_bytes(capabilities().width, capabilities().bits_per_pixel))),
      picture_(picture_bytes(capabilities())) {}

Status ReplugPanel::do_write(const Rect& area, std::span<const std::uint8_t> pixels, int stride) noexcept {
  const std::size_t left = row_bytes(area.x, capabilities().bits_per_pixel);
  const std::size_t across = row_bytes(area.width, capabilities().bits_per_pixel);
  for (int y = 0; y < area.height; ++y) {
    const auto from = pixels.subspan(static_cast<std::size_t>(y) * static_cast<std::size_t>(stride), across);
    const auto row = static_cast<std::size_t>(area.y + y) * static_cast<std::size_t>(stride_);
    std::ranges::copy(from, std::span(picture_).subspan(row + left, across).begin());
  }
  return survive(inner_->write(area, pixels, stride));
}

Status ReplugPanel::do_load_palette(std::span<const std::uint8_t> palette) noexcept {
  palette_.resize(std::max(palette_.size(), palette.size()));
  std::ranges::copy(palette, palette_.begin());
  return survive(inner_->load_palette(palette));
}

Status ReplugPanel::do_wait_for_vblank() noexcept {
  if (const Status s = inner_->wait_for_vblank(); !s.ok()) return survive(s);
  return survive(port_->look());
}

Status ReplugPanel::survive(Status s) {
  if (s.error() != Error::disconnected || patience_ == 0) return s;
  return look_for_device(*clock_, patience_, [this] { return restore(); });
}

Status ReplugPanel::restore() {
  if (const Status s = port_->reopen(); !s.ok()) return s;
  if (const Status s = restart_(); !s.ok()) return s;
  if (!palette_.empty())
    if (const Status s = inner_->load_palette(palette_); !s.ok()) return s;
  const Rect whole{0, 0, capabilities().width, capabilities().height};
  if (const Status s = inner_->write(whole, picture_, stride_); !s.ok()) return s;
  ++reconnects_;
  return {};
}

}  // namespace hal::hid
