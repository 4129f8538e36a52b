// SPDX-License-Identifier: MIT
//
// Flat colour: the sinks `Solid` (store an index) and `Xor` (exclusive-or it).
//
// Rule: the clip that a sink reports is what its caller asked for, cut to the surface, so a primitive that
// keeps inside the clip can't write outside the buffer, whatever its arguments. Nothing is checked a second
// time here. Bit budget: columns and rows within 2^21, byte offsets below 2^30 (see `PixelView`).
//
// A cursor is always inlined: optimising for size, compilers would call a function of two
// instructions for each pixel.
//
// Cost: a span is an address (5 instructions on Cortex-M3) and a run of bytes (`image/fill.hpp`); a cursor
// step one instruction at 8 bits a pixel, about four below.
#pragma once

#include <intaglio/image/fill.hpp>
#include <intaglio/image/row.hpp>
#include <intaglio/image/surface.hpp>
#include <intaglio/raster/sink.hpp>

#include <cstdint>

namespace intaglio::raster {

namespace detail {

/// A place on a surface of less than 8 bits a pixel: a byte, and the bits of one pixel in it.
template <image::PixelFormat F, class Ink>
class FlatCursor {
 public:
  [[gnu::always_inline]] constexpr FlatCursor(const image::Surface<F>& surface, int x, int y,
                                              image::Pattern pattern) noexcept
      : byte_(surface.byte_at(x, y)),
        stride_(surface.stride()),
        mask_(F::max_index << surface.shift_at(x)),
        pattern_(pattern) {}

  [[gnu::always_inline]] constexpr void put() const noexcept { Ink::put(*byte_, mask_, pattern_); }
  [[gnu::always_inline]] constexpr void up() noexcept { byte_ -= stride_; }
  [[gnu::always_inline]] constexpr void down() noexcept { byte_ += stride_; }
  [[gnu::always_inline]] constexpr void turn_over() noexcept { stride_ = -stride_; }
  [[gnu::always_inline]] constexpr void right() noexcept {
    if (mask_ == rightmost) {
      mask_ = leftmost;
      ++byte_;
    } else {
      mask_ = F::order == image::BitOrder::lsb_first ? mask_ << F::bits : mask_ >> F::bits;
    }
  }
  [[gnu::always_inline]] constexpr void left() noexcept {
    if (mask_ == leftmost) {
      mask_ = rightmost;
      --byte_;
    } else {
      mask_ = F::order == image::BitOrder::lsb_first ? mask_ >> F::bits : mask_ << F::bits;
    }
  }

 private:
  static constexpr unsigned leftmost = F::max_index << F::shift(0);
  static constexpr unsigned rightmost = F::max_index << F::shift(F::pixels_per_byte - 1);

  std::uint8_t* byte_;
  int stride_;
  unsigned mask_;
  image::Pattern pattern_;
};

/// A place on a surface of 8 bits a pixel: an address.
template <image::PixelFormat F, class Ink>
requires(F::bits == 8) class FlatCursor<F, Ink> {
 public:
  [[gnu::always_inline]] constexpr FlatCursor(const image::Surface<F>& surface, int x, int y,
                                              image::Pattern pattern) noexcept
      : byte_(surface.byte_at(x, y)), stride_(surface.stride()), pattern_(pattern) {}

  [[gnu::always_inline]] constexpr void put() const noexcept { Ink::put(*byte_, pattern_); }
  [[gnu::always_inline]] constexpr void up() noexcept { byte_ -= stride_; }
  [[gnu::always_inline]] constexpr void down() noexcept { byte_ += stride_; }
  [[gnu::always_inline]] constexpr void turn_over() noexcept { stride_ = -stride_; }
  [[gnu::always_inline]] constexpr void right() noexcept { ++byte_; }
  [[gnu::always_inline]] constexpr void left() noexcept { --byte_; }

 private:
  std::uint8_t* byte_;
  int stride_;
  image::Pattern pattern_;
};

/// One index, written to a surface by an `Ink`.
template <image::PixelFormat F, class Ink>
class FlatSink {
 public:
  using Format = F;
  using Cursor = FlatCursor<F, Ink>;

  constexpr FlatSink(const image::Surface<F>& surface, unsigned index, const linear::Rect& clip) noexcept
      : surface_(surface),
        clip_(linear::in_domain(clip) ? linear::intersect(surface.bounds(), clip) : linear::Rect{}),
        pattern_(F::replicate(index)) {}
  constexpr FlatSink(const image::Surface<F>& surface, unsigned index) noexcept
      : surface_(surface), clip_(surface.bounds()), pattern_(F::replicate(index)) {}

  /// Where the sink can draw, in the surface's coordinates.
  [[nodiscard]] constexpr const linear::Rect& clip() const noexcept { return clip_; }
  [[nodiscard]] constexpr const image::Surface<F>& surface() const noexcept { return surface_; }
  /// The index it draws with.
  [[nodiscard]] constexpr unsigned index() const noexcept { return pattern_.byte() & F::max_index; }

  /// Writes the pixels x_begin .. x_end-1 of row y. Precondition: they are inside the clip; x_begin < x_end.
  void span(int y, int x_begin, int x_end) const noexcept {
    if constexpr (F::bits == 8)
      Ink::run(surface_.byte_at(x_begin, y), x_end - x_begin, pattern_);
    else
      Ink::run(image::row_run(surface_, y, x_begin, x_end), pattern_);
  }

  /// Writes a rectangle. Precondition: it is inside the clip and holds a pixel.
  void block(const linear::Rect& r) const noexcept {
    if constexpr (F::bits == 8)
      Ink::rows(surface_.byte_at(r.x, r.y), r.width, r.height, surface_.stride(), pattern_);
    else
      Ink::rows(image::row_run(surface_, r.y, r.x, r.right()), r.height, surface_.stride(), pattern_);
  }

  /// Stands on a pixel inside the clip.
  [[nodiscard]] constexpr Cursor cursor(int x, int y) const noexcept { return {surface_, x, y, pattern_}; }

 private:
  image::Surface<F> surface_;
  linear::Rect clip_;
  image::Pattern pattern_;
};

}  // namespace detail

/// Stores one index. `clip` (default: all of it) is cut to the surface; a clip outside the coordinate domain
/// is empty. Only the low bits of `index` that the format has count.
template <image::PixelFormat F>
class Solid : public detail::FlatSink<F, image::Replace> {
 public:
  constexpr Solid(const image::Surface<F>& surface, unsigned index) noexcept
      : detail::FlatSink<F, image::Replace>(surface, index) {}
  constexpr Solid(const image::Surface<F>& surface, unsigned index, const linear::Rect& clip) noexcept
      : detail::FlatSink<F, image::Replace>(surface, index, clip) {}
};

/// Exclusive-ors one index into what is there: the same drawing twice leaves everything as it was.
template <image::PixelFormat F>
class Xor : public detail::FlatSink<F, image::Flip> {
 public:
  constexpr Xor(const image::Surface<F>& surface, unsigned index) noexcept
      : detail::FlatSink<F, image::Flip>(surface, index) {}
  constexpr Xor(const image::Surface<F>& surface, unsigned index, const linear::Rect& clip) noexcept
      : detail::FlatSink<F, image::Flip>(surface, index, clip) {}
};

static_assert(CursorSink<Solid<image::Indexed8>> && BlockSink<Solid<image::Indexed1>>);
static_assert(CursorSink<Xor<image::Indexed4Lsb>> && BlockSink<Xor<image::Indexed8>>);

}  // namespace intaglio::raster
