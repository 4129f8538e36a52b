// SPDX-License-Identifier: MIT
//
// A sink that counts the writes of another, and hands them on by the same way they came: spans as spans,
// blocks as blocks, cursor steps as cursor steps.
#pragma once

#include <intaglio/linear/rect.hpp>
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

  CountingSink(Sink sink, Touches touches) : sink_(std::move(sink)), touches_(touches) {}

  [[nodiscard]] const linear::Rect& clip() const { return sink_.clip(); }
  /// The same counts for another sink.
  [[nodiscard]] CountingSink over(Sink sink) const { return {std::move(sink), touches_}; }

  void span(int y, int x_begin, int x_end) const {
    for (int x = x_begin; x < x_end; ++x) touches_.add(x, y);
    sink_.span(y, x_begin, x_end);
  }

  void block(const linear::Rect& r) const {
    for (int y = r.y; y < r.bottom(); ++y)
      for (int x = r.x; x < r.right(); ++x) touches_.add(x, y);
    sink_.block(r);
  }

  class Cursor {
   public:
    Cursor(const CountingSink& sink, int x, int y)
        : cursor_(sink.sink_.cursor(x, y)), touches_(sink.touches_), x_(x), y_(y) {}
    void put() {
      touches_.add(x_, y_);
      cursor_.put();
    }
    void left() { --x_, cursor_.left(); }
    void right() { ++x_, cursor_.right(); }
    void up() { y_ -= down_, cursor_.up(); }
    void down() { y_ += down_, cursor_.down(); }
    void turn_over() { down_ = -down_, cursor_.turn_over(); }

   private:
    decltype(std::declval<const Sink&>().cursor(0, 0)) cursor_;
    Touches touches_;
    int x_;
    int y_;
    int down_ = 1;
  };
  [[nodiscard]] Cursor cursor(int x, int y) const { return {*this, x, y}; }

 private:
  Sink sink_;
  Touches touches_;
};

}  // namespace host::draw
