// SPDX-License-Identifier: MIT
//
// Panels that are really there, for the host programs: how a user names and wires one, and the panel itself.
//
// Rule: a panel is named by its controller, where wires are given (`--panel ssd1306 --i2c /dev/i2c-1`), or by
// scheme and device (`kms:/dev/dri/card0`). Whatever can't be done is a Failure that names device and line.
#pragma once

#include <hal/input.hpp>
#include <hal/panel.hpp>
#include <hal/vblank.hpp>
#include <intaglio/present/beam_race.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): its own name
class App;
}

namespace host {

/// What the command line says of a real panel. Empty: not said.
struct AttachOptions {
  std::string panel{};  ///< A controller's name, or SCHEME:DEVICE.
  std::string spi{};    ///< "/dev/spidev0.0"
  std::uint32_t spi_hertz = 10'000'000;
  int spi_mode = 0;
  std::string i2c{};               ///< "/dev/i2c-1"
  std::optional<int> address{};    ///< None: the controller's usual.
  std::string bitbang{};           ///< "SCK,MOSI,CS" or "SCK,MOSI": lines.
  std::string gpio = "gpiochip0";  ///< The chip of lines that name none.
  std::string data_command{};      ///< Lines: a number, a name, or CHIP:LINE.
  std::string reset{};
  std::string te{};
  std::string size{};    ///< "240x240", of a TFT's glass.
  std::string offset{};  ///< "0,80": where it begins in the controller's memory.
  bool bgr = false;
  bool mirror = false;
  int rotate = 0;  ///< 0, 90, 180, 270 degrees.
  bool invert = false;
  bool dither = false;                   ///< The program draws 256 colours, the panel shows its greys.
  std::optional<int> contrast{};         ///< 0..255
  std::uint32_t refresh_millihertz = 0;  ///< Where the panel doesn't tell it; 0: its usual.
};

/// What it takes to send frames behind a panel's beam.
struct Beam {
  hal::Clock* clock = nullptr;
  hal::VblankSource* vblanks = nullptr;
  intaglio::present::BeamTiming timing{};
};

class AttachedPanel {
 public:
  AttachedPanel() = default;
  AttachedPanel(const AttachedPanel&) = delete;
  AttachedPanel& operator=(const AttachedPanel&) = delete;
  /// Blanks the panel, unless it was told to `keep` its picture, and gives all lines and devices free.
  virtual ~AttachedPanel() = default;

  [[nodiscard]] virtual hal::Panel& panel() = 0;
  /// How bus and beam race, measured now, which takes some tenths of a second; to be called before the first
  /// frame. None: the panel has nothing to race, or doesn't tell when.
  [[nodiscard]] virtual std::optional<Beam> beam() { return std::nullopt; }
  /// The panel's keys; null if it has none.
  [[nodiscard]] virtual hal::Input* input() { return nullptr; }
  /// "st7789, 240x320, on SPI device /dev/spidev0.0"
  [[nodiscard]] virtual std::string description() const = 0;
  /// What the user should know and hasn't been told yet, in whole lines.
  [[nodiscard]] virtual std::string notices() { return {}; }
  /// What went wrong when a call of the panel failed; "" if there are no words for it.
  [[nodiscard]] virtual std::string fault() const { return {}; }
  /// Lines "KEY VALUE" for a report.
  [[nodiscard]] virtual std::string counters() const { return {}; }
  /// Leaves the picture on the panel when the program ends. False: this kind of panel can't.
  virtual bool keep() { return false; }
};

/// Adds all options but `--panel` itself.
void add_attach_options(CLI::App& app, AttachOptions& options);

/// True if these options mean a real panel: wires are given, or the name has a scheme.
[[nodiscard]] bool means_attached(const AttachOptions& options);

/// Sets the panel up. Throws Failure.
[[nodiscard]] std::unique_ptr<AttachedPanel> attach(const AttachOptions& options);

/// What is plugged in, a line each, in the form that `--panel` takes where it can be.
[[nodiscard]] std::vector<std::string> list_attached();

}  // namespace host
