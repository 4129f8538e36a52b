// SPDX-License-Identifier: MIT
//
// The display modules there are drivers for, by name: for programs that are told at run time what they are
// connected to.
//
// Rule: a program that names its panel in its source uses the driver's class and links that driver alone;
// this table links them all.
#pragma once

#include <hal/panels/bus_panel.hpp>
#include <hal/panels/command_port.hpp>
#include <hal/panels/dcs_panel.hpp>
#include <hal/panels/rotation.hpp>

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace hal::panels {

/// What differs from the module's own glass.
struct ModuleGlass {
  /// 0: the module's own.
  int width = 0;
  int height = 0;
  /// Beyond the module's own offset in the controller's memory, 0..319.
  int column_offset = 0;
  int row_offset = 0;
  /// Columns count the other way, colours lie the other way.
  bool mirrored = false;
  bool bgr = false;
  friend constexpr bool operator==(const ModuleGlass&, const ModuleGlass&) noexcept = default;
};

/// How a module is used; what it is itself is in the table.
struct ModuleOptions {
  Rotation rotation = Rotation::by_0;
  /// Shows the picture's negative.
  bool negative = false;
  /// The module's own if not given.
  std::optional<std::uint8_t> contrast{};
  /// Modules with a TE output only.
  TearingEffect te = TearingEffect::off;
  int te_line = 0;
  /// TFT modules only: the glass is refreshed from its last row to its first.
  bool scan_up = false;
  /// TFT modules only.
  ModuleGlass glass{};
  /// Frames a second times 1000, counted by the clock where there is no TE line; 0: the module's own.
  std::uint32_t refresh_millihertz = 0;
  /// As in `DcsOptions`.
  std::span<std::uint8_t> workspace{};
};

/// What a driver is made with.
struct ModuleParts {
  CommandPort* port = nullptr;
  Clock* clock = nullptr;
  VblankSource* vblank = nullptr;
  ModuleOptions options{};
};

/// Memory for whichever driver; the driver lives as long as it.
class ModuleStorage {
 public:
  ModuleStorage() noexcept = default;
  ModuleStorage(const ModuleStorage&) = delete;
  ModuleStorage& operator=(const ModuleStorage&) = delete;

  static constexpr std::size_t size = 1024;
  [[nodiscard]] std::byte* data() noexcept { return bytes_.data(); }

 private:
  alignas(std::max_align_t) std::array<std::byte, size> bytes_{};
};

struct Module {
  std::string_view name;
  std::string_view description;
  /// The glass, not turned.
  int width = 0;
  int height = 0;
  bool spi = false;
  bool i2c = false;
  std::uint8_t i2c_address = 0x3C;
  I2cFraming i2c_framing = I2cFraming::stream;
  /// It has a TE output.
  bool te = false;
  /// Its glass can be another than its own: a TFT.
  bool any_glass = false;
  /// Its own frames a second times 1000.
  std::uint32_t refresh_millihertz = 60'000;
  /// How its beam goes; null where it has no TE output.
  BeamLines (*beam)(const ModuleOptions& options) noexcept = nullptr;
  /// Makes the driver in `storage`, whose last driver ends.
  BusPanel& (*make)(ModuleStorage& storage, const ModuleParts& parts) noexcept = nullptr;
};

/// All modules; each name once.
[[nodiscard]] std::span<const Module> modules() noexcept;

/// The module of a name; null if there is none.
[[nodiscard]] const Module* find_module(std::string_view name) noexcept;

}  // namespace hal::panels
