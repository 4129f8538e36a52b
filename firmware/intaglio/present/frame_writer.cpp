// SPDX-License-Identifier: MIT
#include <intaglio/present/frame_writer.hpp>

#include <algorithm>

namespace intaglio::present {

namespace {

/// The least multiple of `alignment` that is also one of `pixels_per_byte`, which is 1, 2, 4 or 8.
int whole_bytes(int alignment, int pixels_per_byte) noexcept {
  int common = alignment;
  while (common % pixels_per_byte != 0) common += alignment;
  return common;
}

}  // namespace

WriteControl::WriteControl(hal::Panel& panel, const Pace& pace, int pixels_per_byte,
                           BeamChaser* chaser) noexcept
    : panel_(&panel),
      chaser_(chaser),
      pacer_(pace),
      pixels_per_byte_(pixels_per_byte),
      owed_({panel.capabilities().width, panel.capabilities().height},
            whole_bytes(panel.capabilities().x_alignment, pixels_per_byte),
            panel.capabilities().y_alignment) {
  owed_.add_all();
}

Status WriteControl::prepare() noexcept {
  if (chaser_ == nullptr) return {};
  cut_ = cut_along_scan(panel_->capabilities(), 8 / pixels_per_byte_, chased_lines);
  return chaser_->prepare(cut_.sizes(panel_->capabilities()), cut_.travel());
}

Status WriteControl::owe(std::span<const linear::Rect> dirty) noexcept {
  for (const linear::Rect& r : dirty)
    if (!linear::in_domain(r)) return {Error::out_of_domain, Argument::rectangle};
  for (const linear::Rect& r : dirty) owed_.add(r).ignore();
  return {};
}

Status WriteControl::send(std::span<const std::uint8_t> buffer, int stride, int bits_per_pixel,
                          std::span<const std::uint8_t> palette) noexcept {
  std::uint32_t vblank = 0;
  if (chaser_ != nullptr) {
    const Result<std::uint32_t> aim = chaser_->aim(pacer_);
    if (!aim.ok()) return aim.status();
    vblank = aim.value();
  } else {
    if (const Status s = pacer_.wait(*panel_, 0); !s.ok()) return s;
    vblank = panel_->vblank_count();
  }
  const bool dropped = can_wait(panel_->capabilities(), palette) && pacer_.drop(vblank);
  hal::Status s = load(palette);
  if (dropped) return to_status(s);
  if (s.ok())
    s = chaser_ != nullptr ? chase(buffer, stride, bits_per_pixel) : send_now(buffer, stride, bits_per_pixel);
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

hal::Status WriteControl::write(const linear::Rect& r, std::span<const std::uint8_t> buffer, int stride,
                                int bits_per_pixel) noexcept {
  const auto first = static_cast<std::size_t>(r.y * stride + r.x * bits_per_pixel / 8);
  return panel_->write({r.x, r.y, r.width, r.height}, buffer.subspan(first), stride);
}

hal::Status WriteControl::send_now(std::span<const std::uint8_t> buffer, int stride,
                                   int bits_per_pixel) noexcept {
  for (const linear::Rect& r : owed_.rects())
    if (const hal::Status s = write(r, buffer, stride, bits_per_pixel); !s.ok()) return s;
  return {};
}

hal::Status WriteControl::chase(std::span<const std::uint8_t> buffer, int stride,
                                int bits_per_pixel) noexcept {
  const hal::Capabilities& c = panel_->capabilities();
  for (int step = 0; step < cut_.count; ++step) {
    const linear::Rect band = cut_.band(c, step);
    const auto on_band = [&band](const linear::Rect& r) { return !linear::intersect(r, band).empty(); };
    if (std::ranges::none_of(owed_.rects(), on_band)) continue;
    const int first = cut_.first_scanned(c, step);
    chaser_->before_write(first, first + cut_.lines_of(band));
    if (const hal::Status s = write(band, buffer, stride, bits_per_pixel); !s.ok()) return s;
    chaser_->after_write();
  }
  chaser_->complete();
  return {};
}

}  // namespace intaglio::present
