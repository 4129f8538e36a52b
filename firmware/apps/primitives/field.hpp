// SPDX-License-Identifier: MIT
//
// A field of the card: where a primitive draws, and what it may depend on.
#pragma once

#include <intaglio/image/surface.hpp>
#include <intaglio/linear/point.hpp>
#include <intaglio/linear/rect.hpp>
#include <intaglio/number/angle.hpp>
#include <intaglio/raster/solid.hpp>
#include <intaglio/status.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <firmware/apps/place.hpp>

namespace apps::primitives {

namespace image = intaglio::image;
namespace linear = intaglio::linear;
namespace number = intaglio::number;
namespace raster = intaglio::raster;
using intaglio::Status;
using linear::Point;
using linear::Rect;
using linear::SubPoint;
using number::Angle;

/// Widest and highest field; memory for workspaces is measured by it.
inline constexpr int longest_side = 128;

/// The first thing that goes wrong; the rest is drawn all the same.
class FirstFault {
 public:
  void keep(Status status) {
    if (status_.ok()) status_ = status;
  }
  [[nodiscard]] Status status() const { return status_; }

 private:
  Status status_;
};

template <image::PixelFormat F>
struct Field {
  image::Surface<F> target;
  Rect area;
  Angle turn;  ///< A little more every frame.
  FirstFault* faults;

  void keep(Status status) const { faults->keep(status); }

  /// An index other than the background's, spread over those there are.
  [[nodiscard]] static constexpr unsigned shade(unsigned sixteenths) noexcept {
    return 1U + sixteenths * (F::max_index - 1U) / 16U;
  }
  [[nodiscard]] raster::Solid<F> pen(unsigned sixteenths) const {
    return raster::Solid<F>(target, shade(sixteenths), area);
  }
  [[nodiscard]] Point middle() const { return {area.x + area.width / 2, area.y + area.height / 2}; }
  /// Half the shorter side, but at least four pixels.
  [[nodiscard]] int unit() const {
    const int shorter = area.width < area.height ? area.width : area.height;
    return shorter < 8 ? 4 : shorter / 2;
  }
  /// The place `percent` of the unit away from the middle, `degrees` ahead of the turn.
  [[nodiscard]] SubPoint place(int percent, int degrees) const {
    return around(middle(), unit() * linear::subpixel_one / 100 * percent,
                  turn + Angle::from_degrees(degrees));
  }
  /// A regular polygon or star: `N` places, each `step` degrees ahead of the one before.
  template <std::size_t N>
  [[nodiscard]] std::array<SubPoint, N> ring(int percent, int step, int first = 0) const {
    std::array<SubPoint, N> places;
    for (std::size_t i = 0; i < N; ++i) places[i] = place(percent, first + static_cast<int>(i) * step);
    return places;
  }
};

}  // namespace apps::primitives
