// SPDX-License-Identifier: MIT
//
// A run on a real panel: its VBLANKs are the rhythm, and nothing else holds frames back.
#include <host/attach/interruption.hpp>
#include <host/attach/metered_panel.hpp>
#include <host/failure.hpp>
#include <host/sim/output_file.hpp>
#include <host/sim/simulation.hpp>
#include <intaglio/status_text.hpp>

#include <fmt/format.h>

#include <cstdio>
#include <limits>
#include <optional>
#include <ostream>

namespace host {

using intaglio::present::BeamChaser;

void list_panels(std::ostream& out) {
  const std::vector<std::string> all = list_attached();
  for (const std::string& line : all) out << line << '\n';
  if (all.empty()) out << "No real panel, bus or GPIO chip was found that this user may see.\n";
}

void run_on_real_panel(const Options& options) {
  const Program& program = program_of(options);
  std::optional<OutputFile> report;
  if (options.report) report.emplace(*options.report);
  // From here on a signal may not end the program: it would leave the panel as it happens to be.
  watch_for_interruption(SecondSignal::waits);
  const std::unique_ptr<AttachedPanel> attached = attach(options.attach);
  const intaglio::present::Pace pace = pace_of(options, attached->panel().capabilities());
  std::optional<BeamChaser> chaser;
  if (options.chase.value_or(true))
    if (const std::optional<Beam> beam = attached->beam())
      chaser.emplace(*beam->clock, *beam->vblanks, beam->timing);
  if (options.chase == true && !chaser)
    throw Failure("--beam chase: " + attached->description() + " doesn't tell where its beam is");
  BeamChaser* const behind = chaser ? &*chaser : nullptr;
  MeteredPanel panel(attached->panel(), pace.interval, behind);
  if (!options.digest) fmt::print("{} on {}\n", options.program, attached->description());
  const auto tell = [&] { fmt::print(stderr, "{}", attached->notices()); };
  tell();
  intaglio::present::FrameCounts counts;
  const auto on_frame = [&](std::uint32_t frame, std::uint32_t digest) {
    if (counts.dropped == panel.dropped_frames())
      panel.frame_shown();
    else
      panel.frame_dropped();
    if (options.digest) fmt::print("frame {} crc32 {:08x}\n", frame, digest);
    tell();
    return !interrupted();
  };
  const std::uint32_t frames = options.frames.value_or(std::numeric_limits<std::uint32_t>::max());
  const intaglio::Status status =
      program.run(panel, {.pace = pace, .frames = frames, .on_frame = on_frame, .chaser = behind}, counts);
  tell();
  const std::string torn = chaser ? fmt::format("torn_frames {}\n", chaser->torn()) : "";
  const std::string counters = panel.counters() + torn + attached->counters();
  if (report) report->write(counters);
  if (status.ok()) {
    if (!options.digest) fmt::print("{}", counters);
    return;
  }
  const std::string fault = attached->fault();
  throw Failure(fault.empty()
                    ? fmt::format("{} failed: {} {}", options.program, intaglio::to_text(status.argument()),
                                  intaglio::to_text(status.error()))
                    : fault);
}

}  // namespace host
