// SPDX-License-Identifier: MIT
#include <intaglio/present/pacer.hpp>
#include <intaglio/present/panel_port.hpp>

namespace intaglio::present {

Status Pacer::wait(hal::Panel& panel, std::uint32_t ahead) const noexcept {
  while (started_ && after(due_ - ahead, panel.vblank_count()))
    if (const hal::Status s = panel.wait_for_vblank(); !s.ok()) return to_status(s);
  return {};
}

bool Pacer::drop(std::uint32_t vblank) noexcept {
  if (late_ == Late::show || dropped_last_ || !started_ || !after(vblank, due_)) return false;
  dropped_last_ = true;
  due_ += interval_;
  counts_.repeated += interval_;
  ++counts_.dropped;
  ++missed_;
  return true;
}

void Pacer::appeared(std::uint32_t vblank) noexcept {
  if (started_ && after(vblank, due_)) {
    counts_.repeated += vblank - due_;
    ++counts_.late;
    ++missed_;
  }
  started_ = true;
  dropped_last_ = false;
  due_ = vblank + interval_;
  ++counts_.shown;
}

void Pacer::lost(std::uint32_t vblank) noexcept {
  ++counts_.dropped;
  if (!started_) return;
  if (after(vblank, due_)) {
    counts_.repeated += vblank - due_;
    due_ = vblank;
  }
  counts_.repeated += interval_;
  due_ += interval_;
}

}  // namespace intaglio::present
