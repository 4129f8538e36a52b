// SPDX-License-Identifier: MIT
//
// The glass of a simulated panel: what a viewer sees of it, by the effects that the scenario declares.
//
// Rule: without `tearing` and `response` the picture is the memory on display, at the moment one looks. With
// either it is the last whole refresh, line by line as the beam fetched it, and changes once a refresh. Then,
// in this order: colour depth, gamma, response, dead pixels, grid.
#pragma once

#include <hal/sim/effects/response.hpp>
#include <hal/sim/panel.hpp>

#include <functional>
#include <optional>
#include <vector>

namespace hal::sim {

/// A picture of three bytes a pixel, rows close together.
struct View {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;
  friend bool operator==(const View&, const View&) = default;
};

class Glass final : private Observer {
 public:
  /// Dead pixels must lie on the panel. Must die before the panel.
  Glass(Panel& panel, const Effects& effects);
  ~Glass() override;
  Glass(const Glass&) = delete;
  Glass& operator=(const Glass&) = delete;

  /// Sides of the viewer's picture.
  [[nodiscard]] int width() const { return panel_->capabilities().width * scale(); }
  [[nodiscard]] int height() const { return panel_->capabilities().height * scale(); }
  /// True if the picture changes once a refresh, and at no other time.
  [[nodiscard]] bool by_refresh() const { return by_refresh_; }
  /// What a viewer sees now.
  [[nodiscard]] View look() const;
  /// Calls `seen` whenever a refresh is over (only if `by_refresh`); it must not move the clock.
  void on_refresh(std::function<void()> seen) { seen_ = std::move(seen); }

 private:
  void on_line(const ScannedLine& line) override;
  void on_vblank(std::uint64_t refresh, Nanoseconds time) override;

  [[nodiscard]] int scale() const { return effects_.grid ? effects_.grid->scale : 1; }
  /// Colours as depth and gamma leave them.
  void through_channels(std::span<std::uint8_t> rgb) const;

  Panel* panel_;
  Effects effects_;
  bool by_refresh_;
  std::array<std::array<std::uint8_t, 256>, 3> channels_{};  // Filled only with depth or gamma.
  std::optional<Response> response_;
  bool from_first_line_ = false;
  std::vector<std::uint8_t> scanning_;  // The refresh in work.
  std::vector<std::uint8_t> scanned_;   // The last whole one.
  std::function<void()> seen_;
};

}  // namespace hal::sim
