// SPDX-License-Identifier: MIT
#include <host/attach/metered_panel.hpp>

#include <utility>

namespace host {

hal::Status MeteredPanel::do_write(const hal::Rect& area, std::span<const std::uint8_t> pixels,
                                   int stride) noexcept {
  if (!sending_) {
    sending_ = true;
    if (chaser_ != nullptr) told_ = panel_->vblank_count();
    begun_ = told_;
  }
  return panel_->write(area, pixels, stride);
}

std::uint32_t MeteredPanel::do_vblank_count() noexcept { return told_ = panel_->vblank_count(); }

void MeteredPanel::frame_shown() {
  std::uint32_t at = sending_ ? begun_ : told_;
  if (chaser_ != nullptr) at = chaser_->aimed_at();
  sending_ = false;
  const std::uint32_t due = interval_ * (1U + std::exchange(dropped_since_, 0));
  if (frames_++ == 0) {
    first_ = last_ = at;
    return;
  }
  const std::uint32_t lasted = at - last_;
  if (lasted > due) {
    ++late_;
    skipped_ += lasted - due;
  }
  if (lasted < due) ++early_;
  last_ = at;
}

void MeteredPanel::frame_dropped() {
  sending_ = false;
  skipped_ += interval_;
  ++dropped_;
  ++dropped_since_;
}

std::string MeteredPanel::counters() const {
  const auto line = [](const char* key, std::uint32_t value) {
    return std::string(key) + ' ' + std::to_string(value) + '\n';
  };
  return line("frames", frames_) + line("vblanks", vblanks()) + line("late_frames", late_) +
         line("skipped_vblanks", skipped_) + line("early_frames", early_) + line("dropped_frames", dropped_);
}

}  // namespace host
