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

struct Program {
  std::string_view name;
  std::string_view description;
  /// Runs `frames` frames, one every `interval` VBLANKs.
  intaglio::Status (*run)(hal::Panel& panel, int interval, std::uint32_t frames, const OnFrame& on_frame);
};

/// All programs, those a user is most likely to want first.
[[nodiscard]] std::span<const Program> programs();
/// The program of that name, or null.
[[nodiscard]] const Program* find_program(std::string_view name);

/// `Program::run` for panels of one pixel format.
template <class App, intaglio::image::PixelFormat F>
intaglio::Status run_in_format(hal::Panel& panel, int interval, std::uint32_t frames,
                               const OnFrame& on_frame) {
  App app(intaglio::present::screen_info(panel.capabilities()));
  if (panel.capabilities().buffers > 0) {
    intaglio::present::SwapChain<F> screen(panel, interval);
    return intaglio::present::run(app, screen, frames, on_frame);
  }
  const hal::Capabilities& c = panel.capabilities();
  std::vector<std::uint8_t> memory(
      static_cast<std::size_t>(intaglio::present::FrameWriter<F>::memory_for({c.width, c.height})));
  intaglio::present::FrameWriter<F> screen(panel, memory, interval);
  return intaglio::present::run(app, screen, frames, on_frame);
}

/// `Program::run` of a class template over the pixel format.
template <template <intaglio::image::PixelFormat> class App>
intaglio::Status run_on_panel(hal::Panel& panel, int interval, std::uint32_t frames,
                              const OnFrame& on_frame) {
  namespace image = intaglio::image;
  const auto run = [&]<class F>(F) { return run_in_format<App<F>, F>(panel, interval, frames, on_frame); };
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
