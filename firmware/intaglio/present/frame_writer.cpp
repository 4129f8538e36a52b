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

WriteControl::WriteControl(hal::Panel& panel, int interval, int pixels_per_byte) noexcept
    : panel_(&panel),
      pacer_(interval),
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
  pacer_.appeared(panel_->vblank_count());
  if (!palette.empty())
    if (const hal::Status s = panel_->load_palette(palette); !s.ok()) return to_status(s);
  for (const linear::Rect& r : owed_.rects()) {
    const auto first = static_cast<std::size_t>(r.y * stride + r.x * bits_per_pixel / 8);
    const hal::Status s = panel_->write({r.x, r.y, r.width, r.height}, buffer.subspan(first), stride);
    if (!s.ok()) return to_status(s);
  }
  owed_.clear();
  return {};
}

}  // namespace intaglio::present
