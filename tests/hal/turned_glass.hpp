// SPDX-License-Identifier: MIT
//
// What the tests of display controllers share: a viewer who turns the glass, pictures of random rectangles,
// and a bus that fails at every transfer in turn.
#pragma once

#include <hal/mock/strict_controller.hpp>
#include <hal/panels/bus_panel.hpp>
#include <hal/panels/rotation.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <random>
#include <vector>

namespace glass {

using hal::mock::Pattern;
using hal::panels::Rotation;

inline constexpr Rotation rotations[] = {Rotation::by_0, Rotation::by_90, Rotation::by_180, Rotation::by_270};

/// The place on a glass of width x height where pixel (x, y) of a picture lies that is turned clockwise.
struct Place {
  int x = 0, y = 0;
};
inline Place place(Rotation rotation, int width, int height, int x, int y) {
  if (rotation == Rotation::by_90) return {width - 1 - y, x};
  if (rotation == Rotation::by_180) return {width - 1 - x, height - 1 - y};
  if (rotation == Rotation::by_270) return {y, height - 1 - x};
  return {x, y};
}

/// The picture as someone sees it who has turned the glass.
inline Pattern picture(const Pattern& glass, Rotation rotation) {
  const bool quarter = rotation == Rotation::by_90 || rotation == Rotation::by_270;
  Pattern seen = Pattern::blank(quarter ? glass.height : glass.width, quarter ? glass.width : glass.height);
  for (int y = 0; y < seen.height; ++y)
    for (int x = 0; x < seen.width; ++x) {
      const Place at = place(rotation, glass.width, glass.height, x, y);
      seen.at(x, y) = glass.at(at.x, at.y);
    }
  return seen;
}

/// Random aligned rectangles of random pixels: writes them and keeps what should be seen.
class Writer {
 public:
  /// `shown` is what a viewer sees for an index at a place of the picture.
  Writer(hal::Panel& panel, unsigned seed, std::function<int(int index, int x, int y)> shown)
      : panel_(&panel), random_(seed), shown_(std::move(shown)) {
    const hal::Capabilities& c = panel.capabilities();
    expected_ = Pattern::blank(c.width, c.height);
  }

  hal::Status write(bool whole) {
    const hal::Capabilities& c = panel_->capabilities();
    area_ = {0, 0, c.width, c.height};
    if (!whole) {
      side(c.width, c.x_alignment, area_.x, area_.width);
      side(c.height, c.y_alignment, area_.y, area_.height);
    }
    stride_ = (area_.width * c.bits_per_pixel + 7) / 8 + below(3);
    pixels_.resize(static_cast<std::size_t>(stride_ * area_.height));
    for (std::uint8_t& byte : pixels_) byte = static_cast<std::uint8_t>(random_());
    return write_again();
  }
  /// The same once more, as after a fault.
  hal::Status write_again() {
    const hal::Capabilities& c = panel_->capabilities();
    const hal::Status status = panel_->write(area_, pixels_, stride_);
    if (!status.ok()) return status;
    for (int y = 0; y < area_.height; ++y)
      for (int x = 0; x < area_.width; ++x) {
        const int bit = x * c.bits_per_pixel;
        const int byte = pixels_[static_cast<std::size_t>(y * stride_ + bit / 8)];
        const bool low_first = c.bit_order == hal::BitOrder::lsb_first;
        const int shift = low_first ? bit % 8 : 8 - c.bits_per_pixel - bit % 8;
        const int index = byte >> shift & ((1 << c.bits_per_pixel) - 1);
        expected_.at(area_.x + x, area_.y + y) = shown_(index, area_.x + x, area_.y + y);
      }
    return status;
  }
  [[nodiscard]] const Pattern& expected() const { return expected_; }
  [[nodiscard]] const hal::Rect& area() const { return area_; }

 private:
  int below(int limit) { return static_cast<int>(random_() % static_cast<unsigned>(limit)); }
  void side(int length, int alignment, int& begin, int& extent) {
    begin = below((length + alignment - 1) / alignment) * alignment;
    const int blocks = 1 + below((length - begin + alignment - 1) / alignment);
    extent = std::min(blocks * alignment, length - begin);
  }

  hal::Panel* panel_;
  std::mt19937 random_;
  std::function<int(int, int, int)> shown_;
  Pattern expected_;
  hal::Rect area_;
  int stride_ = 0;
  std::vector<std::uint8_t> pixels_;
};

/// Writes `rounds` rectangles, whole pictures among them, and compares every pixel after each.
inline void random_writes_show(hal::Panel& panel, const hal::mock::StrictController& model, Rotation rotation,
                               unsigned seed, int rounds, const std::function<int(int, int, int)>& shown) {
  SCOPED_TRACE("seed " + std::to_string(seed) + ", rotation " + std::to_string(static_cast<int>(rotation)));
  Writer writer(panel, seed, shown);
  ASSERT_EQ(picture(model.displayed(), rotation), writer.expected()) << "cleared at the start";
  for (int round = 0; round < rounds; ++round) {
    ASSERT_TRUE(writer.write(round % 8 == 0).ok());
    const std::string difference =
        side_by_side(writer.expected(), picture(model.displayed(), rotation), false);
    ASSERT_TRUE(difference.empty()) << "round " << round << ": " << difference;
    model.expect_idle();
  }
}

/// True if `scan` is how the beam of the model runs over the turned picture.
inline bool beam_runs_as_told(const hal::Capabilities& c, const hal::mock::StrictController& model,
                              Rotation rotation) {
  const Pattern shape = model.displayed();
  // Numbers the rows of the glass in the order of the beam, and looks at that through the turned glass.
  Pattern order = Pattern::blank(shape.width, shape.height);
  for (int step = 0; step < shape.height; ++step)
    for (int x = 0; x < shape.width; ++x) order.at(x, model.beam_row(step)) = step;
  const Pattern seen = picture(order, rotation);
  const bool across = c.scan == hal::ScanDirection::right || c.scan == hal::ScanDirection::left;
  const bool backwards = c.scan == hal::ScanDirection::up || c.scan == hal::ScanDirection::left;
  const int length = across ? seen.width : seen.height;
  bool right = length == shape.height;
  for (int y = 0; y < seen.height; ++y)
    for (int x = 0; x < seen.width; ++x) {
      const int along = across ? x : y;
      right = right && seen.at(x, y) == (backwards ? length - 1 - along : along);
    }
  return right;
}

/// Breaks the wire at every transfer in turn, in the middle of it: the driver must say so, go no further, and
/// do the same again without a trace once the wire is whole. `with` makes model and panel and calls its
/// argument. Every `stride`-th transfer of the many alike in a large picture.
template <class With>
void faults_leave_no_trace(With with, int stride = 1) {
  int transfers = 0;
  with([&](hal::panels::BusPanel& panel, auto& model, Rotation rotation, const auto& shown) {
    ASSERT_TRUE(panel.start().ok());
    Writer writer(panel, 1, shown);
    ASSERT_TRUE(writer.write(false).ok());
    ASSERT_TRUE(writer.write(false).ok());
    ASSERT_TRUE(panel.set_contrast(10).ok());
    ASSERT_TRUE(panel.stop().ok());
    transfers = model.transfers();
    EXPECT_EQ(picture(model.displayed(), rotation),
              Pattern::blank(writer.expected().width, writer.expected().height));
  });
  for (int good = 0; good < transfers; good += good < 80 || transfers - good < 40 ? 1 : stride) {
    SCOPED_TRACE("transfer " + std::to_string(good));
    with([&](hal::panels::BusPanel& panel, auto& model, Rotation rotation, const auto& shown) {
      model.fail_after(good, good % 3);
      Writer writer(panel, 1, shown);
      const auto until_good = [&](const std::function<hal::Status()>& call,
                                  const std::function<hal::Status()>& again) {
        hal::Status status = call();
        if (status.ok()) return;
        EXPECT_EQ(status.error(), hal::Error::bus);
        EXPECT_EQ(model.transfers(), good) << "a driver that goes on after a fault";
        model.fail_after(1 << 30);
        status = again();
        EXPECT_TRUE(status.ok());
      };
      const auto twice = [&](const std::function<hal::Status()>& call) { until_good(call, call); };
      twice([&] { return panel.start(); });
      until_good([&] { return writer.write(false); }, [&] { return writer.write_again(); });
      until_good([&] { return writer.write(false); }, [&] { return writer.write_again(); });
      twice([&] { return panel.set_contrast(10); });
      EXPECT_TRUE(side_by_side(writer.expected(), picture(model.displayed(), rotation), false).empty());
      twice([&] { return panel.stop(); });
      EXPECT_FALSE(model.on());
    });
  }
}

}  // namespace glass
