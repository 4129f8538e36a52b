// SPDX-License-Identifier: MIT
//
// Blit: copies a picture onto a surface.
//
// Rule: the pixel of the source's corner lands on `position`; pixels outside the target's bounds or outside
// `clip` are left out, and nothing else changes. A rule says which indices are copied and what they become:
// `Everything`, `ColourKey` (all but one index), `Remap` (through a table), `KeyedRemap` (both). Source and
// target may overlap in one buffer: the result is as if the source had been read before the first write, for
// every format, down to pixels within one byte.
//
// How: source and target of one format and one stride lie a constant number of pixels apart in memory, so it
// is enough to walk towards the source: forwards if the target comes first, else backwards. Overlapping views
// for which that isn't so (other stride, other format) are refused. Bit budget: position within 2^20 and
// sizes within 2^20, so every edge stays within 2^21. Cost: where formats and places within a byte agree,
// `Everything` moves whole bytes by std::memmove, a call a row; else pixel by pixel.
#pragma once

#include <intaglio/image/row.hpp>
#include <intaglio/image/surface.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

namespace intaglio::image {

/// Copies every pixel. Indices stay as they are, so the target's format must hold all of the source's.
struct Everything {
  template <PixelFormat Target, PixelFormat Source>
  static constexpr bool converts = Source::bits <= Target::bits;

  template <PixelFormat Target, PixelFormat Source>
  [[nodiscard]] constexpr Status check() const noexcept {
    return {};
  }
  [[nodiscard]] constexpr bool shows(unsigned) const noexcept { return true; }
  [[nodiscard]] constexpr unsigned map(unsigned index) const noexcept { return index; }
};

/// Copies every pixel but those of one index.
struct ColourKey {
  unsigned key = 0;

  template <PixelFormat Target, PixelFormat Source>
  static constexpr bool converts = Source::bits <= Target::bits;

  template <PixelFormat Target, PixelFormat Source>
  [[nodiscard]] constexpr Status check() const noexcept {
    if (key > Source::max_index) return {Error::out_of_range, Argument::colour, Source::max_index};
    return {};
  }
  [[nodiscard]] constexpr bool shows(unsigned index) const noexcept { return index != key; }
  [[nodiscard]] constexpr unsigned map(unsigned index) const noexcept { return index; }
};

/// Copies every pixel, index i as table[i]. The table has an entry for every index of the source's format.
struct Remap {
  std::span<const std::uint8_t> table;

  template <PixelFormat Target, PixelFormat Source>
  static constexpr bool converts = true;

  template <PixelFormat Target, PixelFormat Source>
  [[nodiscard]] constexpr Status check() const noexcept {
    if (table.size() <= Source::max_index) return {Error::too_small, Argument::table, Source::max_index + 1U};
    for (std::size_t index = 0; index <= Source::max_index; ++index)
      if (table[index] > Target::max_index) return {Error::out_of_range, Argument::table, Target::max_index};
    return {};
  }
  [[nodiscard]] constexpr bool shows(unsigned) const noexcept { return true; }
  [[nodiscard]] constexpr unsigned map(unsigned index) const noexcept { return table[index]; }
};

/// Copies every pixel but those of one index of the source, index i as table[i].
struct KeyedRemap {
  unsigned key = 0;
  std::span<const std::uint8_t> table;

  template <PixelFormat Target, PixelFormat Source>
  static constexpr bool converts = true;

  template <PixelFormat Target, PixelFormat Source>
  [[nodiscard]] constexpr Status check() const noexcept {
    const Status status = ColourKey{key}.check<Source, Source>();
    return status.ok() ? Remap{table}.check<Target, Source>() : status;
  }
  [[nodiscard]] constexpr bool shows(unsigned index) const noexcept { return index != key; }
  [[nodiscard]] constexpr unsigned map(unsigned index) const noexcept { return table[index]; }
};

/// A clip that cuts nothing off: every pixel of the coordinate domain that a surface can have.
inline constexpr linear::Rect everywhere{-linear::coordinate_limit, -linear::coordinate_limit,
                                         2 * linear::coordinate_limit, 2 * linear::coordinate_limit};

namespace detail {

/// True if pixels of both formats lie in memory alike.
template <PixelFormat F, PixelFormat G>
inline constexpr bool same_layout = F::bits == G::bits && (F::bits == 8 || F::order == G::order);

/// Which way to walk through memory.
enum class Walk : std::uint8_t { forwards, backwards, impossible };

/// The way to walk from `source` to `target`, both of `size` pixels, that reads every pixel before it is
/// overwritten. Precondition: neither is empty.
template <PixelFormat F, PixelFormat G>
[[nodiscard]] Walk walk_between(const Surface<F>& target, linear::Point at, const Picture<G>& source,
                                linear::Point from, linear::Size size) noexcept {
  // Compared as numbers: the views may look at different objects, whose pointers have no order.
  const auto address = [](const std::uint8_t* byte) { return reinterpret_cast<std::uintptr_t>(byte); };
  const int right = size.width - 1;
  const int down = size.height - 1;
  const std::uintptr_t to_first = address(target.byte_at(at.x, at.y));
  const std::uintptr_t to_last = address(target.byte_at(at.x + right, at.y + down));
  const std::uintptr_t from_first = address(source.byte_at(from.x, from.y));
  const std::uintptr_t from_last = address(source.byte_at(from.x + right, from.y + down));
  if (to_last < from_first || from_last < to_first) return Walk::forwards;
  if (!same_layout<F, G> || (down > 0 && target.stride() != source.stride())) return Walk::impossible;
  if (to_first != from_first) return to_first < from_first ? Walk::forwards : Walk::backwards;
  return target.slot_at(at.x) <= source.slot_at(from.x) ? Walk::forwards : Walk::backwards;
}

/// Takes the bits under `mask` from `bits`.
constexpr void merge(std::uint8_t& byte, unsigned bits, unsigned mask) noexcept {
  byte = static_cast<std::uint8_t>((byte & ~mask) | (bits & mask));
}

/// Moves a run of bytes from `source`, in which the same bits belong to the run.
inline void move_run(const MaskedRun& to, const std::uint8_t* source, Walk walk) noexcept {
  if (to.length == 0) {
    merge(*to.first, *source, to.head & to.tail);
    return;
  }
  const auto head = [&] { merge(*to.first, *source, to.head); };
  const auto tail = [&] {
    if (to.tail != 0) merge(to.first[to.length], source[to.length], to.tail);
  };
  if (walk == Walk::backwards)
    tail();
  else
    head();
  std::memmove(to.first + 1, source + 1, static_cast<std::size_t>(to.length - 1));
  if (walk == Walk::backwards)
    head();
  else
    tail();
}

/// Copies a row pixel by pixel. The views come by value: writing a pixel can't change them then, and the
/// compiler needn't load them again.
template <PixelFormat F, PixelFormat G, class Rule>
void blit_row(const Surface<F> target, linear::Point at, const Picture<G> source, linear::Point from,
              int width, Walk walk, const Rule rule) noexcept {
  const int step = walk == Walk::backwards ? -1 : 1;
  int column = walk == Walk::backwards ? width - 1 : 0;
  for (int left = width; left > 0; --left, column += step) {
    const unsigned index = source.get(from.x + column, from.y);
    if (rule.shows(index)) target.set(at.x + column, at.y, rule.map(index));
  }
}

}  // namespace detail

/// Copies `source` so that the corner of its bounds lands on `position`, in the coordinates of `target`.
/// Errors: position (outside the domain), rectangle (the clip is), colour (a key that the source's format
/// can't hold), table (shorter than the source's format asks for, or with an entry that the target's can't
/// hold), source (overlaps the target in another format or stride). Nothing is drawn on error.
template <PixelFormat F, PixelFormat G, class Byte, class Rule = Everything>
requires(Rule::template converts<F, G>) Status
    blit(const Surface<F>& target, linear::Point position, const PixelView<G, Byte>& source,
         const Rule& rule = {}, const linear::Rect& clip = everywhere)
noexcept {
  if (!linear::in_domain(position)) return {Error::out_of_domain, Argument::position};
  if (!linear::in_domain(clip)) return {Error::out_of_domain, Argument::rectangle};
  if (const Status status = rule.template check<F, G>(); !status.ok()) return status;
  const linear::Rect placed{position.x, position.y, source.size().width, source.size().height};
  const linear::Rect part = linear::intersect(linear::intersect(placed, target.bounds()), clip);
  if (part.empty()) return {};

  const Picture<G> picture = source;
  const linear::Point from{picture.bounds().x + (part.x - position.x),
                           picture.bounds().y + (part.y - position.y)};
  const detail::Walk walk =
      detail::walk_between(target, {part.x, part.y}, picture, from, {part.width, part.height});
  if (walk == detail::Walk::impossible) return {Error::mismatched, Argument::source};

  const int step = walk == detail::Walk::backwards ? -1 : 1;
  int row = walk == detail::Walk::backwards ? part.height - 1 : 0;
  for (int left = part.height; left > 0; --left, row += step) {
    if constexpr (std::same_as<Rule, Everything> && detail::same_layout<F, G>) {
      if (target.slot_at(part.x) == picture.slot_at(from.x)) {
        detail::move_run(row_run(target, part.y + row, part.x, part.right()),
                         picture.byte_at(from.x, from.y + row), walk);
        continue;
      }
    }
    detail::blit_row(target, {part.x, part.y + row}, picture, {from.x, from.y + row}, part.width, walk, rule);
  }
  return {};
}

}  // namespace intaglio::image
