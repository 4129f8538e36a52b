// SPDX-License-Identifier: MIT
//
// The simulated time of the panel runs as fast as it can; where someone looks on, frames are held back to the
// rate that was asked for. Digests and files don't depend on that.
#include <hal/sim/tearing.hpp>
#include <host/attach/interruption.hpp>
#include <host/failure.hpp>
#include <host/sim/apng.hpp>
#include <host/sim/program.hpp>
#include <host/sim/simulation.hpp>
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
  return *spec;
}

std::unique_ptr<Viewer> viewer_of(const Options& options, const hal::Capabilities& panel) {
  if (options.window || (!options.terminal && !options.digest && window_possible()))
    return open_window("Intaglio: " + options.program, panel.width, panel.height, options.scale);
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
        panel_(panel_of(options), clock_),
        animation_path_(animation_path(options)) {
    const hal::Capabilities& c = panel_.capabilities();
    if (c.buffers > 0) tearing_.emplace(panel_);
    // Files first: a path that can't be written is said before a window opens.
    if (!animation_path_.empty())
      animation_ =
          std::make_unique<ApngWriter>(animation_path_, c.width, c.height, options.frames_per_second);
    if (options.png)
      still_ = std::make_unique<ApngWriter>(*options.png, c.width, c.height, options.frames_per_second);
    viewer_ = viewer_of(options, c);
    endless_ = viewer_ && !options.frames;
    frames_ =
        options.frames.value_or(endless_ ? std::numeric_limits<std::uint32_t>::max() : unattended_frames);
    show_progress_ = !viewer_ && !options.digest && isatty(STDERR_FILENO) == 1;
  }

  void run() {
    watch_for_interruption(SecondSignal::ends_at_once);
    start_ = std::chrono::steady_clock::now();
    const intaglio::Status status =
        program_.run(panel_, interval_of(options_, panel_.capabilities()), frames_,
                     [this](std::uint32_t frame, std::uint32_t digest) { return on_frame(frame, digest); });
    viewer_.reset();
    if (show_progress_) fmt::print(stderr, "\r\x1b[K");
    if (!status.ok())
      throw Failure(fmt::format("{} failed: {} {}", options_.program, intaglio::to_text(status.argument()),
                                intaglio::to_text(status.error())));
    report_tearing();
    finish_files();
  }

 private:
  bool on_frame(std::uint32_t frame, std::uint32_t digest) {
    if (options_.digest) fmt::print("frame {} crc32 {:08x}\n", frame, digest);
    ++shown_;
    const bool recording = animation_ && (!endless_ || frame < longest_recording);
    if (recording || viewer_ || still_) {
      take_picture();
      if (recording) animation_->add(picture_);
    }
    if (show_progress_) fmt::print(stderr, "\rrecording frame {} of {}", frame + 1, frames_);
    if (interrupted()) return false;
    if (!viewer_) return true;
    const bool go_on = viewer_->show(picture_);
    std::this_thread::sleep_until(
        start_ + std::chrono::nanoseconds(1'000'000'000LL * (frame + 1LL) / options_.frames_per_second));
    return go_on;
  }

  /// Says what a viewer would have seen amiss.
  void report_tearing() {
    if (!tearing_) return;
    constexpr std::size_t most = 5;
    const std::vector<hal::sim::Tear>& tears = tearing_->tears();
    for (std::size_t i = 0; i < std::min(tears.size(), most); ++i)
      fmt::print(stderr, "torn picture: {}\n", hal::sim::to_text(tears[i]));
    if (tears.size() > most) fmt::print(stderr, "... and {} more\n", tears.size() - most);
  }

  void take_picture() {
    hal::sim::Picture displayed = panel_.displayed();
    picture_.width = displayed.width;
    picture_.height = displayed.height;
    picture_.bytes = std::move(displayed.rgb);
  }

  void finish_files() {
    if (still_) {
      still_->add(picture_);
      still_->finish();
    }
    if (animation_) animation_->finish();
    if (options_.digest) return;
    if (still_) fmt::print("Last picture: {}\n", *options_.png);
    if (!animation_) return;
    const std::uint32_t recorded = animation_->frames();
    fmt::print("Animated picture of {}: {}\n",
               recorded == shown_ ? fmt::format("{} frames", recorded)
                                  : fmt::format("the first {} of {} frames", recorded, shown_),
               animation_path_);
  }

  const Options& options_;
  const Program& program_;
  hal::sim::VirtualClock clock_;
  hal::sim::Panel panel_;
  /// A write panel tears by its nature: it shows what has arrived.
  std::optional<hal::sim::TearingDetector> tearing_;
  std::string animation_path_;
  std::unique_ptr<ApngWriter> animation_;
  std::unique_ptr<ApngWriter> still_;
  std::unique_ptr<Viewer> viewer_;
  bool endless_ = false;
  bool show_progress_ = false;
  std::uint32_t frames_ = 0;
  std::uint32_t shown_ = 0;
  std::chrono::steady_clock::time_point start_;
  RgbPicture picture_;
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

void list_all(std::ostream& out) {
  out << "Programs:\n";
  for (const Program& program : programs())
    out << fmt::format("  {:12}{}\n", program.name, program.description);
  out << "\nPanels:\n";
  for (const hal::sim::PanelSpec& panel : hal::sim::catalog()) {
    const hal::Capabilities& c = panel.capabilities;
    out << fmt::format("  {:12}{}x{}x{}: {}\n", panel.name, c.width, c.height, c.bits_per_pixel,
                       panel.description);
  }
  out << "  WxHxB     any size, B bits a pixel (1, 2, 4, 8): paletted, double buffered\n"
         "\nEffects:\n"
         "  tearing   reported with frame and line where two frames meet in one picture (panels with frame "
         "buffers)\n"
         "  The panel is ideal otherwise.\n";
}

void simulate(const Options& options) { Simulation(options).run(); }

}  // namespace host
