// SPDX-License-Identifier: MIT
#include <host/attach/metered_panel.hpp>

namespace host {

hal::Status MeteredPanel::do_write(const hal::Rect& area, std::span<const std::uint8_t> pixels,
                                   int stride) noexcept {
  if (!sending_) {
    sending_ = true;
    begun_ = told_;
  }
  return panel_->write(area, pixels, stride);
}

std::uint32_t MeteredPanel::do_vblank_count() noexcept { return told_ = panel_->vblank_count(); }

void MeteredPanel::frame_shown() {
  const std::uint32_t at = sending_ ? begun_ : told_;
  sending_ = false;
  if (frames_++ == 0) {
    first_ = last_ = at;
    return;
  }
  const std::uint32_t lasted = at - last_;
  if (lasted > interval_) {
    ++late_;
    skipped_ += lasted - interval_;
  }
  if (lasted < interval_) ++early_;
  last_ = at;
}

std::string MeteredPanel::counters() const {
  const auto line = [](const char* key, std::uint32_t value) {
    return std::string(key) + ' ' + std::to_string(value) + '\n';
  };
  return line("frames", frames_) + line("vblanks", vblanks()) + line("late_frames", late_) +
         line("skipped_vblanks", skipped_) + line("early_frames", early_);
}

}  // namespace host
