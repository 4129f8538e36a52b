// SPDX-License-Identifier: MIT
#include <intaglio/present/frame_writer.hpp>

namespace intaglio::present {

namespace {

/// The least multiple of `alignment` that is also one of `pixels_per_byte`, which is 1, 2, 4 or 8.
int whole_bytes(int alignment, int pixels_per_byte) noexcept {
  int common = alignment;
  while (common % pixels_per_byte != 0) common += alignment;
  return common;
}

}  // namespace

WriteControl::WriteControl(hal::Panel& panel, const Pace& pace, int pixels_per_byte) noexcept
    : panel_(&panel),
      pacer_(pace),
      owed_({panel.capabilities().width, panel.capabilities().height},
            whole_bytes(panel.capabilities().x_alignment, pixels_per_byte),
            panel.capabilities().y_alignment) {
  owed_.add_all();
}

Status WriteControl::owe(std::span<const linear::Rect> dirty) noexcept {
  for (const linear::Rect& r : dirty)
    if (!linear::in_domain(r)) return {Error::out_of_domain, Argument::rectangle};
  for (const linear::Rect& r : dirty) owed_.add(r).ignore();
  return {};
}

Status WriteControl::send(std::span<const std::uint8_t> buffer, int stride, int bits_per_pixel,
                          std::span<const std::uint8_t> palette) noexcept {
  if (const Status s = pacer_.wait(*panel_, 0); !s.ok()) return s;
  const std::uint32_t vblank = panel_->vblank_count();
  const bool dropped = can_wait(panel_->capabilities(), palette) && pacer_.drop(vblank);
  const hal::Status s = dropped ? load(palette) : send_now(buffer, stride, bits_per_pixel, palette);
  if (dropped) return to_status(s);
  if (s.ok()) {
    pacer_.appeared(vblank);
    owed_.clear();
  } else {
    pacer_.lost(vblank);
  }
  return to_status(s);
}

hal::Status WriteControl::load(std::span<const std::uint8_t> palette) noexcept {
  if (palette.empty()) return {};
  if (panel_->capabilities().palette_on_write) owed_.add_all();
  return panel_->load_palette(palette);
}

hal::Status WriteControl::send_now(std::span<const std::uint8_t> buffer, int stride, int bits_per_pixel,
                                   std::span<const std::uint8_t> palette) noexcept {
  if (const hal::Status s = load(palette); !s.ok()) return s;
  for (const linear::Rect& r : owed_.rects()) {
    const auto first = static_cast<std::size_t>(r.y * stride + r.x * bits_per_pixel / 8);
    const hal::Status s = panel_->write({r.x, r.y, r.width, r.height}, buffer.subspan(first), stride);
    if (!s.ok()) return s;
  }
  return {};
}

}  // namespace intaglio::present
