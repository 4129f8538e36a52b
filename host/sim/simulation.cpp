// SPDX-License-Identifier: MIT
//
// The simulated time of the panel runs as fast as it can; where someone looks on, frames are held back to the
// rate that was asked for. Digests and files don't depend on that.
#include <hal/sim/effects/draw.hpp>
#include <hal/sim/effects/glass.hpp>
#include <hal/sim/effects/parse.hpp>
#include <hal/sim/tearing.hpp>
#include <host/attach/interruption.hpp>
#include <host/failure.hpp>
#include <host/sim/apng.hpp>
#include <host/sim/explain.hpp>
#include <host/sim/output_file.hpp>
#include <host/sim/program.hpp>
#include <host/sim/simulated_beam.hpp>
#include <host/sim/simulation.hpp>
#include <host/sim/timeline.hpp>
#include <host/sim/trace.hpp>
#include <host/sim/viewer.hpp>
#include <intaglio/status_text.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <limits>
#include <memory>
#include <optional>
#include <ostream>
#include <thread>
#include <unistd.h>

namespace host {

namespace {

constexpr std::uint32_t unattended_frames = 120;
/// A run that only the user ends records no more than this.
constexpr std::uint32_t longest_recording = 600;

hal::sim::PanelSpec panel_of(const Options& options) {
  const auto spec = hal::sim::find_panel(options.panel);
  if (!spec)
    throw Failure(
        fmt::format("no panel '{}': give a name of --list, or WIDTHxHEIGHTxBITS with sides of "
                    "1 to 16384 and 1, 2, 4 or 8 bits; real panels need wires (--spi, --i2c, --bitbang)",
                    options.panel));
  hal::sim::PanelSpec panel = *spec;
  if (options.buffers) {
    if (panel.capabilities.buffers == 0)
      throw Failure(
          fmt::format("--buffers: {} has memory of its own, which frames are sent to", options.panel));
    panel.capabilities.buffers = *options.buffers;
  }
  return panel;
}

intaglio::present::Pace pace_of(const Options& options, const hal::sim::PanelSpec& panel,
                                const hal::sim::Effects& effects) {
  using intaglio::present::Late;
  using intaglio::present::Order;
  intaglio::present::Pace pace = pace_of(options, panel.capabilities);
  pace.order = options.order.value_or(Order::every);
  if (options.order && panel.capabilities.buffers == 0)
    throw Failure(
        fmt::format("--order: {} has memory of its own, where no frame waits for its VBLANK", options.panel));
  if (pace.order == Order::every) return pace;
  if (!draws_ahead(panel.capabilities))
    throw Failure("--order latest: needs --buffers 3, or nothing is drawn while a frame waits");
  if (pace.late == Late::drop)
    throw Failure("--order latest: a frame is replaced by the latest, so none is dropped for being late");
  if (pace.interval != 1)
    throw Failure(fmt::format("--order latest: a frame at every VBLANK, so --fps can't be {}",
                              options.frames_per_second));
  if (!effects.draw || effects.draw->least == 0)
    throw Failure(
        "--order latest: needs --effects draw=TIME, or all frames are drawn before the first VBLANK");
  return pace;
}

hal::sim::Effects effects_of(const Options& options, const hal::sim::PanelSpec& panel) {
  const auto parsed = hal::sim::parse_effects(options.effects, panel);
  if (const std::string* const wrong = std::get_if<std::string>(&parsed))
    throw Failure("--effects: " + *wrong + "; intaglio-sim --list names them");
  hal::sim::Effects effects = std::get<hal::sim::Effects>(parsed);
  // Which frame is on display isn't known when the next one is drawn: a picture is what the beam fetched.
  if (draws_ahead(panel.capabilities)) effects.tearing = true;
  return effects;
}

std::unique_ptr<Viewer> viewer_of(const Options& options, const hal::sim::Glass& glass) {
  if (options.window || (!options.terminal && !options.digest && window_possible()))
    return open_window("Intaglio: " + options.program, glass.width(), glass.height(), options.scale);
  if (options.terminal || (!options.digest && terminal_possible())) return open_terminal();
  return nullptr;
}

std::string animation_path(const Options& options) {
  if (options.animation) return *options.animation;
  return options.digest ? std::string() : options.program + ".png";
}

class Simulation {
 public:
  explicit Simulation(const Options& options)
      : options_(options),
        program_(program_of(options)),
        effects_(effects_of(options, panel_of(options))),
        panel_(panel_of(options), clock_, effects_),
        glass_(panel_, effects_),
        pace_(pace_of(options, panel_.spec(), effects_)),
        animation_path_(animation_path(options)) {
    if (panel_.capabilities().buffers > 0 || effects_.tearing || options.explain || options.trace)
      tearing_.emplace(panel_);
    // Where frames are dropped, the timeline knows which ones the panel was asked for.
    if (options.explain || options.trace || pace_.late == intaglio::present::Late::drop)
      timeline_.emplace(panel_, clock_, pace_.interval);
    if (options.chase.value_or(false)) chase_beam();
    if (glass_.by_refresh()) glass_.on_refresh([this] { take_picture(); });
    pictures_per_second_ = options.frames_per_second;
    if (glass_.by_refresh())
      pictures_per_second_ = static_cast<int>((panel_.capabilities().refresh_millihertz + 500U) / 1000U);
    // Files first: a path that can't be written is said before a window opens.
    if (!animation_path_.empty())
      animation_ = std::make_unique<ApngWriter>(animation_path_, glass_.width(), glass_.height(),
                                                pictures_per_second_);
    if (options.png)
      still_ =
          std::make_unique<ApngWriter>(*options.png, glass_.width(), glass_.height(), pictures_per_second_);
    if (options.trace) trace_.emplace(*options.trace);
    viewer_ = viewer_of(options, glass_);
    endless_ = viewer_ && !options.frames;
    frames_ =
        options.frames.value_or(endless_ ? std::numeric_limits<std::uint32_t>::max() : unattended_frames);
    show_progress_ = !viewer_ && !options.digest && isatty(STDERR_FILENO) == 1;
  }

  void run() {
    watch_for_interruption(SecondSignal::ends_at_once);
    start_ = std::chrono::steady_clock::now();
    const intaglio::Status status = program_.run(
        panel_,
        {.pace = pace_,
         .frames = frames_,
         .on_frame = [this](std::uint32_t frame, std::uint32_t digest) { return on_frame(frame, digest); },
         .on_draw = [this](std::uint32_t frame, bool begins) { on_draw(frame, begins); },
         .chaser = chaser_ ? &*chaser_ : nullptr},
        counts_);
    if (timeline_) timeline_->set_counts(counts_);
    // Until the last frame has been seen in a whole refresh.
    if (glass_.by_refresh() || timeline_) clock_.advance(2U * panel_.frame_time());
    viewer_.reset();
    if (show_progress_) fmt::print(stderr, "\r\x1b[K");
    if (!status.ok())
      throw Failure(fmt::format("{} failed: {} {}", options_.program, intaglio::to_text(status.argument()),
                                intaglio::to_text(status.error())));
    report();
    if (!options_.explain && (options_.buffers || options_.late || options_.order))
      fmt::print(options_.digest ? stderr : stdout, "Frames: {}.\n", to_text(counts_));
    finish_files();
  }

 private:
  void chase_beam() {
    std::string notice;
    const intaglio::present::BeamTiming timing = simulated_beam(panel_of(options_), effects_, notice);
    if (!notice.empty()) fmt::print(stderr, "{}: {}", options_.panel, notice);
    vblanks_.emplace(panel_, clock_);
    chaser_.emplace(clock_, *vblanks_, timing);
    if (timeline_) timeline_->chase(*chaser_);
  }

  bool on_frame(std::uint32_t frame, std::uint32_t digest) {
    if (options_.digest) fmt::print("frame {} crc32 {:08x}\n", frame, digest);
    if (dropped_as_late()) {
      if (timeline_) timeline_->drop();
    } else if (panel_.capabilities().buffers == 0) {
      panel_.mark_frame();
    }
    if (!glass_.by_refresh()) take_picture();
    if (show_progress_) fmt::print(stderr, "\rrecording frame {} of {}", frame + 1, frames_);
    return !interrupted() && !closed_;
  }

  /// True if the frame just told of isn't shown.
  bool dropped_as_late() {
    const bool dropped = pace_.order == intaglio::present::Order::every && counts_.dropped != dropped_before_;
    dropped_before_ = counts_.dropped;
    return dropped;
  }

  void on_draw(std::uint32_t frame, bool begins) {
    if (begins) {
      if (timeline_) timeline_->draw_begins(frame);
      return;
    }
    if (effects_.draw) clock_.advance(hal::sim::draw_time(*effects_.draw, frame));
    if (timeline_) timeline_->draw_ends();
  }

  /// Says what a viewer would have seen amiss.
  void report() {
    if (!tearing_) return;
    if (trace_) trace_->write(trace(*timeline_, tearing_->tears()));
    if (options_.explain) {
      fmt::print(options_.digest ? stderr : stdout, "{}", explain(*timeline_, tearing_->tears()));
      return;
    }
    constexpr std::size_t most = 5;
    const std::vector<hal::sim::Tear> tears =
        timeline_ ? timeline_->of_frames(tearing_->tears()) : tearing_->tears();
    for (std::size_t i = 0; i < std::min(tears.size(), most); ++i)
      fmt::print(stderr, "torn picture: {}\n", hal::sim::to_text(tears[i], 0));
    if (tears.size() > most) fmt::print(stderr, "... and {} more\n", tears.size() - most);
  }

  /// A frame, or a refresh where the glass shows those, goes to whoever looks on and into the files.
  void take_picture() {
    const bool recording = animation_ && (!endless_ || pictures_ < longest_recording);
    if (!recording && !viewer_ && !still_) return;
    hal::sim::View view = glass_.look();
    picture_.width = view.width;
    picture_.height = view.height;
    picture_.bytes = std::move(view.rgb);
    if (pictures_ == options_.png_of) asked_for_ = picture_;
    ++pictures_;
    if (recording) animation_->add(picture_);
    if (!viewer_ || closed_) return;
    closed_ = !viewer_->show(picture_);
    std::this_thread::sleep_until(
        start_ + std::chrono::nanoseconds(1'000'000'000LL * static_cast<std::int64_t>(pictures_) /
                                          pictures_per_second_));
  }

  void finish_files() {
    if (still_) {
      if (options_.png_of && !asked_for_)
        throw Failure(fmt::format("--png-of {}: there were only {} pictures", *options_.png_of, pictures_));
      still_->add(asked_for_ ? *asked_for_ : picture_);
      still_->finish();
    }
    if (animation_) animation_->finish();
    if (options_.digest) return;
    if (still_) fmt::print("{}: {}\n", options_.png_of ? "Picture" : "Last picture", *options_.png);
    if (!animation_) return;
    const std::uint32_t recorded = animation_->frames();
    const std::string_view what = glass_.by_refresh() ? "refreshes" : "frames";
    fmt::print("Animated picture of {}: {}\n",
               recorded == pictures_ ? fmt::format("{} {}", recorded, what)
                                     : fmt::format("the first {} of {} {}", recorded, pictures_, what),
               animation_path_);
  }

  const Options& options_;
  const Program& program_;
  hal::sim::VirtualClock clock_;
  hal::sim::Effects effects_;
  hal::sim::Panel panel_;
  hal::sim::Glass glass_;
  intaglio::present::Pace pace_;
  intaglio::present::FrameCounts counts_;
  std::uint32_t dropped_before_ = 0;
  /// A write panel tears by its nature: it shows what has arrived. It is watched only if asked for.
  std::optional<hal::sim::TearingDetector> tearing_;
  std::optional<Timeline> timeline_;
  std::optional<SimulatedVblanks> vblanks_;
  std::optional<intaglio::present::BeamChaser> chaser_;
  std::string animation_path_;
  std::unique_ptr<ApngWriter> animation_;
  std::unique_ptr<ApngWriter> still_;
  std::optional<OutputFile> trace_;
  std::unique_ptr<Viewer> viewer_;
  bool endless_ = false;
  bool show_progress_ = false;
  std::uint32_t frames_ = 0;
  int pictures_per_second_ = 0;
  std::uint32_t pictures_ = 0;
  bool closed_ = false;
  std::chrono::steady_clock::time_point start_;
  RgbPicture picture_;
  std::optional<RgbPicture> asked_for_;  // The one of --png-of.
};

}  // namespace

const Program& program_of(const Options& options) {
  const Program* const program = find_program(options.program);
  if (program == nullptr)
    throw Failure(fmt::format("no program is named '{}'; intaglio-sim --list names them", options.program));
  return *program;
}

int interval_of(const Options& options, const hal::Capabilities& panel) {
  const auto asked = static_cast<std::uint32_t>(options.frames_per_second) * 1000U;
  return static_cast<int>(std::max(1U, (panel.refresh_millihertz + asked / 2U) / asked));
}

intaglio::present::Pace pace_of(const Options& options, const hal::Capabilities& panel) {
  using intaglio::present::Late;
  if (options.late == Late::drop && panel.buffers == 1)
    throw Failure("--late drop: with one buffer a frame is on display while it is drawn");
  return {interval_of(options, panel), options.late.value_or(Late::show)};
}

void list_all(std::ostream& out) {
  out << "Programs:\n";
  for (const Program& program : programs())
    out << fmt::format("  {:17}{}\n", program.name, program.description);
  out << "\nPanels:\n";
  for (const hal::sim::PanelSpec& panel : hal::sim::catalog()) {
    const hal::Capabilities& c = panel.capabilities;
    out << fmt::format("  {:17}{}x{}x{}: {}\n", panel.name, c.width, c.height, c.bits_per_pixel,
                       panel.description);
  }
  out << "  WxHxB            any size, B bits a pixel (1, 2, 4, 8): paletted, double buffered\n"
         "\nEffects (--effects; the panel is ideal otherwise):\n";
  for (const hal::sim::EffectHelp& effect : hal::sim::effect_help())
    out << fmt::format("  {:10}{:32}{}\n", effect.name, effect.value, effect.does);
  out << "  Torn pictures of panels with frame buffers are reported in any case.\n"
         "\nEffects of a panel where they are named without a value:\n";
  for (const hal::sim::PanelSpec& panel : hal::sim::catalog()) {
    std::string values;
    for (std::size_t i = 0; i < hal::sim::effect_count; ++i) {
      const std::string value = hal::sim::effect_default(static_cast<hal::sim::Effect>(i), panel);
      if (!value.empty())
        values += fmt::format("{}{} {}", values.empty() ? "" : "; ", hal::sim::effect_help()[i].name, value);
    }
    out << fmt::format("  {:17}{}\n", panel.name, values);
  }
}

void simulate(const Options& options) { Simulation(options).run(); }

}  // namespace host
