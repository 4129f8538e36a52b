// SPDX-License-Identifier: MIT
//
// The programs of firmware/apps as the simulator knows them: a name, and a way to run it on a panel whose
// pixel format is known only at run time.
#pragma once

#include <hal/panel.hpp>
#include <intaglio/present/run.hpp>
#include <intaglio/status.hpp>

#include <cstdint>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

namespace host {

/// Told when a frame is on display, with its digest; false ends the run.
using OnFrame = std::function<bool(std::uint32_t frame, std::uint32_t digest)>;

/// Told when the drawing of a frame, or of a band of it, begins and when it ends.
using OnDraw = std::function<void(std::uint32_t frame, bool begins)>;

/// How a program is run.
struct RunOptions {
  intaglio::present::Pace pace{};
  std::uint32_t frames = 1;
  OnFrame on_frame{};  ///< May be empty, as the next.
  OnDraw on_draw{};
  /// Sends the frames of a write panel behind its beam; null: each goes out when it is due. It serves this
  /// run alone.
  intaglio::present::BeamChaser* chaser = nullptr;
};

struct Program {
  std::string_view name;
  std::string_view description;
  /// Runs frames of the program. `counts` says at every call of `on_frame`, and in the end, what became of
  /// the frames so far. With three buffers the program draws ahead: `on_frame` is called when a frame has
  /// been asked for, not when it is on display.
  intaglio::Status (*run)(hal::Panel& panel, const RunOptions& options,
                          intaglio::present::FrameCounts& counts);
};

/// All programs, those a user is most likely to want first.
[[nodiscard]] std::span<const Program> programs();
/// The program of that name, or null.
[[nodiscard]] const Program* find_program(std::string_view name);

/// A program whose drawing is watched.
template <class App>
class Watched {
 public:
  Watched(const intaglio::present::ScreenInfo& screen, const OnDraw& on_draw)
      : app_(screen), on_draw_(&on_draw) {}

  void update(std::uint32_t frame) {
    frame_ = frame;
    app_.update(frame);
  }
  [[nodiscard]] std::span<const std::uint8_t> palette() const { return app_.palette(); }
  template <class Surface>
  intaglio::Status draw(Surface target) const {
    if (*on_draw_) (*on_draw_)(frame_, true);
    const intaglio::Status status = app_.draw(target);
    if (*on_draw_) (*on_draw_)(frame_, false);
    return status;
  }

 private:
  App app_;
  const OnDraw* on_draw_;
  std::uint32_t frame_ = 0;
};

/// True if a program draws the next frame while one waits for its VBLANK.
[[nodiscard]] inline bool draws_ahead(const hal::Capabilities& panel) { return panel.buffers >= 3; }

/// A swap chain that makes a program wait for its frame to be shown only if there is no buffer to draw ahead
/// in.
template <intaglio::image::PixelFormat F>
class SwapScreen : public intaglio::present::SwapChain<F> {
 public:
  using intaglio::present::SwapChain<F>::SwapChain;

  [[nodiscard]] intaglio::Status wait_until_shown() noexcept {
    return draws_ahead(this->control().panel().capabilities()) ? intaglio::Status{} : settle();
  }
  [[nodiscard]] intaglio::Status settle() noexcept {
    return intaglio::present::SwapChain<F>::wait_until_shown();
  }
};

/// `Program::run` on a screen.
template <class App, class Screen>
intaglio::Status run_on_screen(App& app, Screen& screen, const RunOptions& options,
                               intaglio::present::FrameCounts& counts) {
  return intaglio::present::run(app, screen, options.frames, [&](std::uint32_t frame, std::uint32_t digest) {
    counts = screen.counts();
    return !options.on_frame || options.on_frame(frame, digest);
  });
}

/// `Program::run` for panels of one pixel format.
template <class App, intaglio::image::PixelFormat F>
intaglio::Status run_in_format(hal::Panel& panel, const RunOptions& options,
                               intaglio::present::FrameCounts& counts) {
  using intaglio::present::FrameWriter;
  const hal::Capabilities& c = panel.capabilities();
  Watched<App> app(intaglio::present::screen_info(c), options.on_draw);
  if (c.buffers > 0) {
    SwapScreen<F> screen(panel, options.pace);
    intaglio::Status s = run_on_screen(app, screen, options, counts);
    if (s.ok()) s = screen.settle();
    counts = screen.counts();
    return s;
  }
  std::vector<std::uint8_t> memory(static_cast<std::size_t>(FrameWriter<F>::memory_for({c.width, c.height})));
  FrameWriter<F> screen = options.chaser != nullptr
                              ? FrameWriter<F>(panel, memory, *options.chaser, options.pace)
                              : FrameWriter<F>(panel, memory, options.pace);
  return run_on_screen(app, screen, options, counts);
}

/// `Program::run` of a class template over the pixel format.
template <template <intaglio::image::PixelFormat> class App>
intaglio::Status run_on_panel(hal::Panel& panel, const RunOptions& options,
                              intaglio::present::FrameCounts& counts) {
  namespace image = intaglio::image;
  const auto run = [&]<class F>(F) { return run_in_format<App<F>, F>(panel, options, counts); };
  const bool lsb = panel.capabilities().bit_order == hal::BitOrder::lsb_first;
  switch (panel.capabilities().bits_per_pixel) {
    case 1:
      return lsb ? run(image::Indexed1Lsb{}) : run(image::Indexed1{});
    case 2:
      return lsb ? run(image::Indexed2Lsb{}) : run(image::Indexed2{});
    case 4:
      return lsb ? run(image::Indexed4Lsb{}) : run(image::Indexed4{});
    case 8:
      return run(image::Indexed8{});
    default:
      return {intaglio::Error::mismatched, intaglio::Argument::panel};
  }
}

}  // namespace host
