// SPDX-License-Identifier: MIT
//
// Surfaces: rows of palette indices in memory that someone else owns.
//
// Rule: the pixel (x, y) of `bounds()` lies in byte  offset + y*stride + ((x + phase) >> byte_shift)  of the
// buffer. `offset` and `phase` are chosen once, when the view is made, so a band (a surface whose first row
// isn't row 0) and a sub-surface (whose first column may begin inside a byte) cost nothing more to address
// than a whole frame. A surface is a view, as cheap to copy as a span; the pixel format is its type.
//
// Bit budget: every |y*stride| and the buffer's size stay below 2^30, checked when the view is made.
#pragma once

#include <intaglio/image/format.hpp>
#include <intaglio/linear/rect.hpp>
#include <intaglio/status.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

namespace intaglio::image {

namespace detail {
/// Every offset into a surface's memory is below this. (Not a member: a static member of 64 bits makes GCC
/// for Arm remark on every function that takes a view by value.)
inline constexpr std::int64_t max_bytes = std::int64_t{1} << 30U;
}  // namespace detail

/// A view of pixels. `Byte` is `std::uint8_t` (a surface to draw on) or `const std::uint8_t` (a picture to
/// read); use the names `Surface` and `Picture`.
template <PixelFormat F, class Byte>
class PixelView {
 public:
  using Format = F;

  /// An empty view: bounds of no pixel.
  constexpr PixelView() noexcept = default;

  /// The view of `size` pixels in `buffer`, rows `stride` bytes apart (0: rows close together). Pixel (0, 0)
  /// is the first of the buffer.
  /// Errors: size (a side below 1 or above 2^20), stride (too small: `needed()` bytes), buffer (too small:
  /// `needed()` bytes).
  [[nodiscard]] static constexpr Result<PixelView> over(std::span<Byte> buffer, linear::Size size,
                                                        int stride = 0) noexcept {
    return over_band(buffer, {0, 0, size.width, size.height}, stride);
  }

  /// The view of one band of a frame: `buffer` holds only the pixels of `band`, but the view keeps the
  /// frame's coordinates, so the same drawing calls give the same picture band by band.
  /// Errors: as `over`; rectangle, if the band leaves the coordinate domain.
  [[nodiscard]] static constexpr Result<PixelView> over_band(std::span<Byte> buffer, const linear::Rect& band,
                                                             int stride = 0) noexcept {
    constexpr int limit = linear::coordinate_limit;
    if (band.width < 1 || band.height < 1) return Status{Error::empty, Argument::size};
    if (band.width > limit || band.height > limit) return Status{Error::too_large, Argument::size, limit};
    if (!linear::in_domain(linear::Point{band.x, band.y}) ||
        !linear::in_domain(linear::Point{band.right(), band.bottom()}))
      return Status{Error::out_of_domain, Argument::rectangle};
    const int least = F::row_bytes(band.width);
    if (stride == 0) stride = least;
    if (stride < least) return Status{Error::too_small, Argument::stride, static_cast<std::uint32_t>(least)};
    const std::int64_t furthest_row = band.bottom() > -band.y ? band.bottom() : -band.y;
    if (furthest_row * stride >= detail::max_bytes) return Status{Error::too_large, Argument::stride};
    const auto needed = static_cast<std::uint32_t>((band.height - 1) * stride + least);
    if (buffer.size() < needed) return Status{Error::too_small, Argument::buffer, needed};
    PixelView view;
    view.data_ = buffer.data();
    view.stride_ = stride;
    view.bounds_ = band;
    view.set_origin(band.x, band.y, 0);
    return view;
  }

  /// A picture of the same pixels.
  // NOLINTNEXTLINE(google-explicit-constructor): whoever may draw may also read
  [[nodiscard]] constexpr operator PixelView<F, const std::uint8_t>() const noexcept
      requires(!std::is_const_v<Byte>) {
    return this->template with_bytes<const std::uint8_t>();
  }

  /// The pixels of `part` (cut to the bounds) as a view of its own, whose pixel (0, 0) is the corner of the
  /// cut rectangle. Nothing in common: an empty view.
  [[nodiscard]] constexpr PixelView sub(const linear::Rect& part) const noexcept {
    const linear::Rect cut = linear::in_domain(part) ? linear::intersect(part, bounds_) : linear::Rect{};
    if (cut.empty()) return {};
    const int column = slot_of(cut.x);
    PixelView view = *this;
    view.data_ = data_ + (cut.y * stride_ + offset_ + (column >> F::byte_shift));
    view.bounds_ = {0, 0, cut.width, cut.height};
    view.set_origin(0, 0, column & (F::pixels_per_byte - 1));
    return view;
  }

  /// The pixels that exist, in this view's coordinates.
  [[nodiscard]] constexpr const linear::Rect& bounds() const noexcept { return bounds_; }
  [[nodiscard]] constexpr linear::Size size() const noexcept { return {bounds_.width, bounds_.height}; }
  [[nodiscard]] constexpr bool empty() const noexcept { return bounds_.empty(); }
  /// Bytes from a row to the next.
  [[nodiscard]] constexpr int stride() const noexcept { return stride_; }

  /// The byte that holds pixel (x, y). Precondition: (x, y) is in `bounds()`.
  [[nodiscard, gnu::always_inline]] constexpr Byte* byte_at(int x, int y) const noexcept {
    return data_ + (y * stride_ + offset_ + (slot_of(x) >> F::byte_shift));
  }
  /// How far left the pixel of column x lies in its byte, in bits. Precondition: x is a column of `bounds()`.
  [[nodiscard]] constexpr unsigned shift_at(int x) const noexcept { return F::shift(slot_of(x)); }

  /// Which pixel of its byte column x is, counted from the left. Precondition: x is a column of `bounds()`.
  [[nodiscard]] constexpr int slot_at(int x) const noexcept { return slot_of(x) & (F::pixels_per_byte - 1); }

  /// The index at (x, y). Precondition: (x, y) is in `bounds()`.
  [[nodiscard, gnu::always_inline]] constexpr unsigned get(int x, int y) const noexcept {
    if constexpr (F::bits == 8) return *byte_at(x, y);
    return static_cast<unsigned>(*byte_at(x, y) >> shift_at(x)) & F::max_index;
  }
  /// Writes the index at (x, y). Precondition: (x, y) is in `bounds()`.
  [[gnu::always_inline]] constexpr void set(int x, int y, unsigned index) const noexcept
      requires(!std::is_const_v<Byte>) {
    Byte* const byte = byte_at(x, y);
    if constexpr (F::bits == 8) {
      *byte = static_cast<std::uint8_t>(index);
    } else {
      const unsigned shift = shift_at(x);
      *byte = static_cast<std::uint8_t>((*byte & ~(F::max_index << shift)) | (index & F::max_index) << shift);
    }
  }

 private:
  template <PixelFormat, class>
  friend class PixelView;

  /// Makes (x, y) the pixel at `data_`, `slot` pixels into its byte.
  constexpr void set_origin(int x, int y, int slot) noexcept {
    // x + phase_ = first_byte * pixels_per_byte + slot, and `offset_` takes the whole bytes back.
    const int first_byte = (x - slot) >> F::byte_shift;
    phase_ = slot - (x - first_byte * F::pixels_per_byte);
    offset_ = -(y * stride_) - first_byte;
  }

  /// Column x counted from the pixel at which byte 0 of `offset_` begins.
  [[nodiscard]] constexpr int slot_of(int x) const noexcept {
    if constexpr (F::bits == 8) return x;
    return x + phase_;
  }

  template <class Other>
  [[nodiscard]] constexpr PixelView<F, Other> with_bytes() const noexcept {
    PixelView<F, Other> view;
    view.data_ = data_;
    view.stride_ = stride_;
    view.offset_ = offset_;
    view.phase_ = phase_;
    view.bounds_ = bounds_;
    return view;
  }

  Byte* data_ = nullptr;
  int stride_ = 0;
  int offset_ = 0;
  int phase_ = 0;
  linear::Rect bounds_{};
};

/// Pixels to draw on.
template <PixelFormat F>
using Surface = PixelView<F, std::uint8_t>;
/// Pixels to read.
template <PixelFormat F>
using Picture = PixelView<F, const std::uint8_t>;

}  // namespace intaglio::image
