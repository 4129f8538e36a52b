// SPDX-License-Identifier: MIT
#include <intaglio/present/pacer.hpp>
#include <intaglio/present/panel_port.hpp>

namespace intaglio::present {

Status Pacer::wait(hal::Panel& panel, std::uint32_t ahead) noexcept {
  while (started_ && panel.vblank_count() - last_ + ahead < interval_)
    if (const hal::Status s = panel.wait_for_vblank(); !s.ok()) return to_status(s);
  return {};
}

void Pacer::appeared(std::uint32_t vblank) noexcept {
  if (started_ && vblank - last_ > interval_) ++missed_;
  started_ = true;
  last_ = vblank;
}

}  // namespace intaglio::present
