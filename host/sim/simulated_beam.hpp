// SPDX-License-Identifier: MIT
//
// The beam of a simulated panel, as a program would know it: edges of its TE line, and times that were
// measured in the same way as on a real panel.
#pragma once

#include <hal/sim/observer.hpp>
#include <hal/sim/panel.hpp>
#include <hal/vblank.hpp>
#include <host/attach/attach.hpp>

#include <optional>
#include <string>

namespace host {

/// Edges of the TE line; without that effect VBLANKs themselves. Must die before the panel.
class SimulatedVblanks final : public hal::VblankSource, private hal::sim::Observer {
 public:
  SimulatedVblanks(hal::sim::Panel& panel, hal::sim::VirtualClock& clock);
  ~SimulatedVblanks() override;
  SimulatedVblanks(const SimulatedVblanks&) = delete;
  SimulatedVblanks& operator=(const SimulatedVblanks&) = delete;

 private:
  std::uint32_t do_count() noexcept override { return panel_->vblank_count(); }
  hal::Status do_wait() noexcept override { return panel_->wait_for_vblank(); }
  hal::Nanoseconds do_last() noexcept override;
  void on_vblank(std::uint64_t refresh, hal::Nanoseconds time) override;
  void on_te(std::uint64_t refresh, hal::Nanoseconds time) override;

  hal::sim::Panel* panel_;
  hal::Clock* clock_;
  hal::Nanoseconds latest_ = 0;  // It may be yet to come.
  hal::Nanoseconds before_ = 0;
};

/// What it takes to send frames behind the beam of such a panel. `notice` says if they will be torn all the
/// same. Throws Failure for a panel that has no beam to chase: one with frame buffers, or no TE line.
[[nodiscard]] intaglio::present::BeamTiming simulated_beam(const hal::sim::PanelSpec& spec,
                                                           const hal::sim::Effects& effects,
                                                           std::string& notice);

}  // namespace host
