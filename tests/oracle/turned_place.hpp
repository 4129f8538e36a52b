// SPDX-License-Identifier: MIT
//
// Oracle: where the pixels of a turned picture come from, by the rule in real numbers, and as seen from
// outside, whatever has drawn them.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace oracle {

/// A place of the source, in pixels from the centre of its corner pixel.
struct TurnedPlace {
  double column = 0;
  double row = 0;

  /// Is it between the outermost centres of a source of w x h?
  [[nodiscard]] bool inside(int w, int h) const {
    return column >= 0 && row >= 0 && column <= w - 1 && row <= h - 1;
  }
  [[nodiscard]] double distance(const TurnedPlace& other) const {
    return std::hypot(column - other.column, row - other.row);
  }
};

/// The place that pixel (x, y) comes from, of a source turned by `steps` / 65536 of a turn about its `pivot`,
/// which lies on (at_x, at_y).
inline TurnedPlace turned_place(double x, double y, int steps, const TurnedPlace& pivot, double at_x,
                                double at_y) {
  const double angle = steps * 3.14159265358979323846 / 32768;
  return {pivot.column + std::cos(angle) * (x - at_x) + std::sin(angle) * (y - at_y),
          pivot.row - std::sin(angle) * (x - at_x) + std::cos(angle) * (y - at_y)};
}

/// Where each pixel of a drawing comes from: the source is drawn again and again, black up to a column or row
/// and white after it. How white a pixel is adds up to its place, off by 1/510 at most in each direction.
class ShownPlaces {
 public:
  /// `draw` takes the values of a source of w x h, and returns those of all pixels, black where there is
  /// none.
  template <class Draw>
  ShownPlaces(int w, int h, Draw draw) {
    std::vector<std::uint8_t> source(static_cast<std::size_t>(w) * static_cast<std::size_t>(h), 255);
    drawn_ = draw(source);
    places_.resize(drawn_.size());
    const auto add = [&](double TurnedPlace::*coordinate) {
      const std::vector<std::uint8_t> shown = draw(source);
      for (std::size_t i = 0; i < shown.size(); ++i) places_[i].*coordinate += shown[i] / 255.0;
    };
    const auto width = static_cast<std::size_t>(w);
    for (int step = 1; step < w; ++step) {
      for (std::size_t i = 0; i < source.size(); ++i)
        source[i] = static_cast<int>(i % width) < step ? 0 : 255;
      add(&TurnedPlace::column);
    }
    for (int step = 1; step < h; ++step) {
      for (std::size_t i = 0; i < source.size(); ++i)
        source[i] = static_cast<int>(i / width) < step ? 0 : 255;
      add(&TurnedPlace::row);
    }
  }
  /// Is the pixel drawn at all?
  [[nodiscard]] bool drawn(std::size_t pixel) const { return drawn_[pixel] != 0; }
  [[nodiscard]] const TurnedPlace& operator[](std::size_t pixel) const { return places_[pixel]; }

 private:
  std::vector<std::uint8_t> drawn_;
  std::vector<TurnedPlace> places_;
};

}  // namespace oracle
