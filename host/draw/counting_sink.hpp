// SPDX-License-Identifier: MIT
//
// A sink that counts the writes of another, and hands them on by the same way they came: spans as spans,
// blocks as blocks, cursor steps as cursor steps. If it is given a polygon, it hands on what is inside, all
// of it as spans.
#pragma once

#include <intaglio/linear/rect.hpp>
#include <intaglio/raster/polygon_clip.hpp>
#include <intaglio/raster/sink.hpp>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace host::draw {

namespace linear = intaglio::linear;

/// Counts per pixel, saturated at 255, rows of `width` from (0, 0).
class Touches {
 public:
  Touches(std::vector<std::uint8_t>& counts, int width) : counts_(&counts), width_(width) {}
  void add(int x, int y) const {
    std::uint8_t& count = counts_->at(static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                                      static_cast<std::size_t>(x));
    if (count < 255) ++count;
  }

 private:
  std::vector<std::uint8_t>* counts_;
  int width_;
};

template <class Sink>
class CountingSink {
 public:
  using Counted = Sink;

  /// `polygon` may be null: nothing more is cut off then.
  CountingSink(Sink sink, Touches touches, const intaglio::raster::PolygonClip* polygon)
      : sink_(std::move(sink)), touches_(touches), polygon_(polygon) {}

  [[nodiscard]] const linear::Rect& clip() const { return sink_.clip(); }
  /// The same counts for another sink.
  [[nodiscard]] CountingSink over(Sink sink) const { return {std::move(sink), touches_, polygon_}; }

  void span(int y, int x_begin, int x_end) const {
    if (polygon_ != nullptr) {
      const CountingSink behind{sink_, touches_, nullptr};
      intaglio::raster::PolygonClipped(behind, *polygon_).span(y, x_begin, x_end);
      return;
    }
    for (int x = x_begin; x < x_end; ++x) touches_.add(x, y);
    sink_.span(y, x_begin, x_end);
  }

  void block(const linear::Rect& r) const {
    if (polygon_ != nullptr) {
      for (int y = r.y; y < r.bottom(); ++y) span(y, r.x, r.right());
      return;
    }
    for (int y = r.y; y < r.bottom(); ++y)
      for (int x = r.x; x < r.right(); ++x) touches_.add(x, y);
    sink_.block(r);
  }

  class Cursor {
   public:
    Cursor(const CountingSink& sink, int x, int y)
        : sink_(&sink), cursor_(sink.sink_.cursor(x, y)), x_(x), y_(y) {}
    void put() {
      if (sink_->polygon_ != nullptr) {
        sink_->span(y_, x_, x_ + 1);
        return;
      }
      sink_->touches_.add(x_, y_);
      cursor_.put();
    }
    void left() { --x_, cursor_.left(); }
    void right() { ++x_, cursor_.right(); }
    void up() { y_ -= down_, cursor_.up(); }
    void down() { y_ += down_, cursor_.down(); }
    void turn_over() { down_ = -down_, cursor_.turn_over(); }

   private:
    const CountingSink* sink_;
    decltype(std::declval<const Sink&>().cursor(0, 0)) cursor_;
    int x_;
    int y_;
    int down_ = 1;
  };
  [[nodiscard]] Cursor cursor(int x, int y) const { return {*this, x, y}; }

 private:
  Sink sink_;
  Touches touches_;
  const intaglio::raster::PolygonClip* polygon_;
};

}  // namespace host::draw
