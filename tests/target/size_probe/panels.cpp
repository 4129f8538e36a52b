// SPDX-License-Identifier: MIT
//
// A run of each display driver, for weighing: set up, colours, a picture, sleep, off.
#include <hal/panels/expanded_panel.hpp>
#include <hal/panels/ili9341.hpp>
#include <hal/panels/ssd0323.hpp>
#include <hal/panels/ssd1306.hpp>
#include <hal/panels/ssd1322.hpp>
#include <hal/panels/st7789.hpp>

using hal::Status;
using hal::panels::CommandPort;

namespace {

/// What a program hands over.
struct Frame {
  hal::Rect area;
  std::span<const std::uint8_t> pixels;
  std::span<const std::uint8_t> palette;
  int stride;
};

Status use(hal::panels::BusPanel& driver, hal::Panel& panel, const Frame& frame) {
  if (const Status s = driver.start(); !s.ok()) return s;
  if (const Status s = panel.load_palette(frame.palette); !s.ok()) return s;
  if (const Status s = panel.write(frame.area, frame.pixels, frame.stride); !s.ok()) return s;
  if (const Status s = panel.wait_for_vblank(); !s.ok()) return s;
  if (const Status s = driver.sleep(true); !s.ok()) return s;
  return driver.stop();
}

}  // namespace

extern "C" {

Status drive_st7789(CommandPort& port, hal::Clock& clock, hal::VblankSource& te,
                    const hal::panels::DcsOptions& options, const Frame& frame) {
  hal::panels::St7789 panel(port, clock, &te, options);
  return use(panel, panel, frame);
}
Status drive_ili9341(CommandPort& port, hal::Clock& clock, hal::VblankSource& te,
                     const hal::panels::DcsOptions& options, const Frame& frame) {
  hal::panels::Ili9341 panel(port, clock, &te, options);
  return use(panel, panel, frame);
}
Status drive_ssd1322(CommandPort& port, hal::Clock& clock, const hal::panels::Ssd1322Options& options,
                     const Frame& frame) {
  hal::panels::Ssd1322 panel(port, &clock, nullptr, options);
  return use(panel, panel, frame);
}
Status drive_ssd0323(CommandPort& port, hal::Clock& clock, const hal::panels::Ssd0323Options& options,
                     const Frame& frame) {
  hal::panels::Ssd0323 panel(port, &clock, options);
  return use(panel, panel, frame);
}
Status drive_ssd1306(CommandPort& port, hal::Clock& clock, const hal::panels::Ssd1306Options& options,
                     const Frame& frame) {
  hal::panels::Ssd1306 panel(port, hal::panels::ssd1306_128x64, &clock, options);
  return use(panel, panel, frame);
}
Status drive_ssd1306_dithered(CommandPort& port, hal::Clock& clock,
                              const hal::panels::Ssd1306Options& options, const Frame& frame,
                              std::span<std::uint8_t> workspace) {
  hal::panels::Ssd1306 panel(port, hal::panels::ssd1306_128x64, &clock, options);
  hal::panels::ExpandedPanel expanded(panel, workspace);
  return use(panel, expanded, frame);
}
}
