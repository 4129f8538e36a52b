// SPDX-License-Identifier: MIT
#include <hal/sim/effects/scan.hpp>
#include <host/attach/beam.hpp>
#include <host/failure.hpp>
#include <host/sim/simulated_beam.hpp>

namespace host {

SimulatedVblanks::SimulatedVblanks(hal::sim::Panel& panel, hal::sim::VirtualClock& clock)
    : panel_(&panel), clock_(&clock) {
  panel.attach(*this);
}

SimulatedVblanks::~SimulatedVblanks() { panel_->detach(*this); }

hal::Nanoseconds SimulatedVblanks::do_last() noexcept { return latest_ > clock_->now() ? before_ : latest_; }

void SimulatedVblanks::on_vblank(std::uint64_t /*refresh*/, hal::Nanoseconds time) {
  before_ = latest_;
  latest_ = time;
}

void SimulatedVblanks::on_te(std::uint64_t /*refresh*/, hal::Nanoseconds time) { latest_ = time; }

intaglio::present::BeamTiming simulated_beam(const hal::sim::PanelSpec& spec,
                                             const hal::sim::Effects& effects, std::string& notice) {
  if (spec.capabilities.buffers > 0)
    throw Failure("--beam chase: " + spec.name + " is shown from frame buffers, so nothing races its beam");
  if (effects.te && !effects.te->connected)
    throw Failure("--beam chase: without a TE line nobody knows where the beam is");
  // On a panel of its own: the one that is looked at begins with the first frame.
  hal::sim::VirtualClock clock;
  hal::sim::Panel panel(spec, clock, effects);
  SimulatedVblanks vblanks(panel, clock);
  const std::optional<hal::Nanoseconds> refresh = measured_refresh(vblanks);
  const std::optional<BusTimes> bus = measured_bus(panel, clock);
  if (!refresh || !bus) throw Failure("--beam chase: " + spec.name + " can't be measured");
  const hal::Capabilities& c = panel.capabilities();
  const int lines = hal::sim::lines_of(c);
  const int total = panel.spec().total_lines;
  const intaglio::present::BeamTiming timing = beam_timing({total - lines, total}, *refresh, *bus);
  ClockedBus clocked;
  if (effects.bus && effects.bus->clocks_per_byte == 8) {
    const int bits = effects.bus->bits_per_pixel > 0 ? effects.bus->bits_per_pixel : c.bits_per_pixel;
    const int pixels = hal::sim::by_columns(c.scan) ? c.height : c.width;
    clocked = {effects.bus->hertz, static_cast<std::uint32_t>(pixels * bits), "bus=", "Hz"};
  }
  notice = tearing_notice(timing, c, clocked);
  return timing;
}

}  // namespace host
