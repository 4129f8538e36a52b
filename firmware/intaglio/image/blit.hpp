// SPDX-License-Identifier: MIT
//
// Blit: copies a picture onto a surface.
//
// Rule: the pixel of the source's corner lands on `position`; pixels outside the target's bounds or outside
// `clip` are left out, and nothing else changes. A rule says which indices are copied and what they become:
// `Everything`, `ColourKey` (all but one index), `Remap` (through a table), `KeyedRemap` (both); `Masked` is
// any of them where a second picture says so. Source and
// target may overlap in one buffer: the result is as if the source had been read before the first write, for
// every format, down to pixels within one byte.
//
// How: source and target of one format and one stride lie a constant number of pixels apart in memory, so it
// is enough to walk towards the source: forwards if the target comes first, else backwards. Overlapping views
// for which that isn't so (other stride, other format) are refused.
//
// Bit budget: position within 2^20 and sizes within 2^20, so every edge stays within 2^21.
//
// Cost: `Everything` between views of one format moves whole bytes: by std::memmove, a call a row, where
// pixels have the same places in their bytes, else each byte joined from two. `ColourKey` does so byte by
// byte, at 8 bits by words where source and target lie alike in theirs. `Remap` goes by eights at 8 bits, and
// a mask of bits over 8 bits a pixel is looked at by bytes: what they hide or show whole costs least. All
// else goes pixel by pixel.
#pragma once

#include <intaglio/image/overlap.hpp>
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

/// Copies what another rule copies, but only where a mask as large as the source isn't 0: the mask's corner
/// lies on the source's. Masks of one bit a pixel are the usual ones.
template <PixelFormat M, class Rule = Everything>
struct Masked {
  Picture<M> mask;
  Rule rule{};

  template <PixelFormat Target, PixelFormat Source>
  static constexpr bool converts = Rule::template converts<Target, Source>;

  template <PixelFormat Target, PixelFormat Source>
  [[nodiscard]] constexpr Status check() const noexcept {
    return rule.template check<Target, Source>();
  }
  [[nodiscard]] constexpr bool shows(unsigned index) const noexcept { return rule.shows(index); }
  [[nodiscard]] constexpr unsigned map(unsigned index) const noexcept { return rule.map(index); }
};
template <PixelFormat M, class Byte>
Masked(PixelView<M, Byte>) -> Masked<M>;
template <PixelFormat M, class Byte, class Rule>
Masked(PixelView<M, Byte>, Rule) -> Masked<M, Rule>;

/// A clip that cuts nothing off: every pixel of the coordinate domain that a surface can have.
inline constexpr linear::Rect everywhere{-linear::coordinate_limit, -linear::coordinate_limit,
                                         2 * linear::coordinate_limit, 2 * linear::coordinate_limit};

namespace detail {

/// A rule that looks at a mask.
template <class Rule>
concept HasMask = requires(const Rule& rule) {
  rule.mask.get(0, 0);
};

/// One whose mask has a bit a pixel.
template <class Rule>
concept HasBitMask = HasMask<Rule> && decltype(Rule::mask)::Format::bits == 1;

/// True if the rule and the source fit each other and the target.
template <PixelFormat F, PixelFormat G, class Byte, class Rule>
[[nodiscard]] constexpr Status check_rule(const Rule& rule, const PixelView<G, Byte>& source) noexcept {
  if constexpr (HasMask<Rule>)
    if (rule.mask.size() != source.size()) return {Error::mismatched, Argument::mask};
  return rule.template check<F, G>();
}

/// True if drawing on `part` of the target could change the rule's mask. Preconditions as `bytes_meet`.
template <PixelFormat F, class Rule>
[[nodiscard]] bool meets_mask(const Rule& rule, const Surface<F>& target, const linear::Rect& part) noexcept {
  if constexpr (HasMask<Rule>) return bytes_meet(target, part, rule.mask);
  return false;
}

/// Shows on pixel (x, y) of the target the pixel `column`, `row` of the source, counted from its corner.
template <PixelFormat F, PixelFormat G, class Rule>
[[gnu::always_inline]] constexpr void show_pixel(const Surface<F>& target, int x, int y,
                                                 const Picture<G>& source, int column, int row,
                                                 const Rule& rule) noexcept {
  if constexpr (HasMask<Rule>)
    if (rule.mask.get(rule.mask.bounds().x + column, rule.mask.bounds().y + row) == 0) return;
  const unsigned index = source.get(source.bounds().x + column, source.bounds().y + row);
  if (rule.shows(index)) target.set(x, y, rule.map(index));
}

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

/// Walks the bytes of a run: `edge(byte, mask)` for the ones that the run may share with its neighbours,
/// `middle(begin, end)` for the whole ones between.
template <class Edge, class Middle>
void walk_run(const MaskedRun& run, Walk walk, Edge edge, Middle middle) noexcept {
  if (run.length == 0) {
    edge(0, run.head & run.tail);
    return;
  }
  const bool back = walk == Walk::backwards;
  if (!back) edge(0, run.head);
  if (back && run.tail != 0) edge(run.length, run.tail);
  middle(1, run.length);
  if (!back && run.tail != 0) edge(run.length, run.tail);
  if (back) edge(0, run.head);
}

/// Copies a run of bytes from `source`, where pixels have the same places in their bytes.
inline void move_run(const MaskedRun& to, const std::uint8_t* source, Walk walk) noexcept {
  walk_run(
      to, walk, [&](int byte, unsigned mask) { merge(to.first[byte], source[byte], mask); },
      [&](int begin, int end) {
        std::memmove(to.first + begin, source + begin, static_cast<std::size_t>(end - begin));
      });
}

/// Bytes of a source as they fall into a target's bytes, where pixels lie `slots` places further right in
/// theirs (left where negative): each is joined of two of the source. The last is `source[last]`; of those at
/// the edges one may not exist, and then a mask hides what is read for it.
template <PixelFormat F>
class JoinedBytes {
 public:
  JoinedBytes(const std::uint8_t* source, int last, int slots) noexcept
      : source_(source),
        last_(last),
        before_(slots < 0 ? -1 : 0),
        left_(static_cast<unsigned>(slots * F::bits & 7)) {}

  /// Byte `byte` of the target's run, one of its edges.
  [[nodiscard]] unsigned edge(int byte) const noexcept {
    return joined(at(byte + before_), at(byte + before_ + 1));
  }
  /// Byte `byte`, one between the edges. Only for slots other than 0.
  [[nodiscard]] unsigned middle(int byte) const noexcept {
    return joined(source_[byte + before_], source_[byte + before_ + 1]);
  }

 private:
  [[nodiscard]] unsigned at(int byte) const noexcept { return byte < 0 || byte > last_ ? 0U : source_[byte]; }
  [[nodiscard]] unsigned joined(unsigned a, unsigned b) const noexcept {
    return (F::order == BitOrder::msb_first ? a << left_ | b >> (8U - left_)
                                            : a >> left_ | b << (8U - left_)) &
           255U;
  }

  const std::uint8_t* source_;
  int last_;
  int before_;
  unsigned left_;
};

/// Calls `put(byte)` for begin .. end-1, in the walk's direction.
template <class Put>
void walk_bytes(int begin, int end, Walk walk, Put put) noexcept {
  if (walk == Walk::backwards)
    while (end-- > begin) put(end);
  else
    for (; begin < end; ++begin) put(begin);
}

/// Copies a run of bytes from a source whose pixels have other places in their bytes.
template <PixelFormat F>
void shift_run(const MaskedRun& to, const JoinedBytes<F>& source, Walk walk) noexcept {
  walk_run(
      to, walk, [&](int byte, unsigned mask) { merge(to.first[byte], source.edge(byte), mask); },
      [&](int begin, int end) {
        walk_bytes(begin, end, walk,
                   [&](int byte) { to.first[byte] = static_cast<std::uint8_t>(source.middle(byte)); });
      });
}

/// The bits of those pixels of a byte that have any of theirs set.
template <PixelFormat F>
[[nodiscard]] constexpr unsigned pixels_set(unsigned byte) noexcept {
  if constexpr (F::bits == 4) byte |= byte >> 2U;
  if constexpr (F::bits != 1) byte |= byte >> 1U;
  constexpr unsigned lowest = 255U / F::max_index;
  return (byte & lowest) * F::max_index;
}
static_assert(pixels_set<Indexed1>(0xA1) == 0xA1 && pixels_set<Indexed2>(0x48) == 0xCC &&
              pixels_set<Indexed4>(0x80) == 0xF0);

/// The same without the pixels of one index.
template <PixelFormat F>
void key_run(const MaskedRun& to, const JoinedBytes<F>& source, Walk walk, Pattern key) noexcept {
  const auto put = [&](int byte, unsigned mask) {
    const unsigned bits = source.edge(byte);
    merge(to.first[byte], bits, mask & pixels_set<F>(bits ^ key.byte()));
  };
  walk_run(to, walk, put,
           [&](int begin, int end) { walk_bytes(begin, end, walk, [&](int byte) { put(byte, 255); }); });
}

/// Copies a row of pixels by `Everything` or, of less than 8 bits, by `ColourKey` between views of one
/// layout, by whole bytes.
template <PixelFormat F, PixelFormat G, class Rule>
void move_row(const Surface<F>& target, linear::Point at, const Picture<G>& source, linear::Point from,
              int width, Walk walk, const Rule& rule) noexcept {
  const MaskedRun run = row_run(target, at.y, at.x, at.x + width);
  const std::uint8_t* const first = source.byte_at(from.x, from.y);
  const int slot = source.slot_at(from.x);
  const int slots = slot - target.slot_at(at.x);
  const JoinedBytes<F> joined(first, (slot + width - 1) >> F::byte_shift, slots);
  if constexpr (std::same_as<Rule, ColourKey>)
    key_run(run, joined, walk, Pattern(F::replicate(rule.key)));
  else if (slots == 0)
    move_run(run, first, walk);
  else if constexpr (F::bits < 8)
    shift_run(run, joined, walk);
}

/// True if `move_row` can copy by the rule.
template <PixelFormat F, PixelFormat G, class Rule>
inline constexpr bool moves_rows = same_layout<F, G> && (std::same_as<Rule, Everything> ||
                                                         (F::bits < 8 && std::same_as<Rule, ColourKey>));

/// Copies a row of bytes, a pixel each.
template <class Rule>
void blit_bytes(std::uint8_t* to, const std::uint8_t* from, int count, Walk walk, const Rule rule) noexcept {
  if constexpr (std::same_as<Rule, ColourKey>) {
    if (walk == Walk::forwards) {
      copy_bytes_but(to, from, count, Pattern(static_cast<std::uint8_t>(rule.key)));
      return;
    }
  }
  if constexpr (std::same_as<Rule, Remap>) {
    if (walk == Walk::forwards) {
      map_bytes(to, from, count, rule.table.data());
      return;
    }
  }
  const int step = walk == Walk::backwards ? -1 : 1;
  int at = walk == Walk::backwards ? count - 1 : 0;
  for (; count > 0; --count, at += step) {
    const unsigned index = from[at];
    if (rule.shows(index)) to[at] = static_cast<std::uint8_t>(rule.map(index));
  }
}

/// Copies, forwards, those bytes of a row, a pixel each, whose bit of a mask is set; the first one's is pixel
/// (x, y) of the mask.
template <PixelFormat M, class Rule>
void blit_bytes_masked(std::uint8_t* to, const std::uint8_t* from, int count, const Picture<M>& mask, int x,
                       int y, const Rule rule) noexcept {
  constexpr bool from_top = M::order == BitOrder::msb_first;
  const std::uint8_t* byte = mask.byte_at(x, y);
  for (int begin = -mask.slot_at(x); begin < count; begin += 8) {
    unsigned bits = *byte++;
    if (begin < 0) bits &= M::mask_from(-begin);
    if (count - begin < 8) bits &= ~M::mask_from(count - begin);
    if (bits == 255U) {
      blit_bytes(to + begin, from + begin, 8, Walk::forwards, rule);
      continue;
    }
    if (from_top) bits <<= 24U;
    for (int at = begin; bits != 0; ++at) {
      const bool set = (bits & (from_top ? 1U << 31U : 1U)) != 0;
      bits = from_top ? bits << 1U : bits >> 1U;
      if (!set) continue;
      const unsigned index = from[at];
      if (rule.shows(index)) to[at] = static_cast<std::uint8_t>(rule.map(index));
    }
  }
}

/// Copies a row pixel by pixel; `from` is counted from the source's corner. The views come by value: writing
/// a pixel can't change them then, and the compiler needn't load them again.
template <PixelFormat F, PixelFormat G, class Rule>
void blit_row(const Surface<F> target, linear::Point at, const Picture<G> source, linear::Point from,
              int width, Walk walk, const Rule rule) noexcept {
  if constexpr (F::bits == 8 && G::bits == 8 && !HasMask<Rule>) {
    const linear::Rect& corner = source.bounds();
    blit_bytes(target.byte_at(at.x, at.y), source.byte_at(corner.x + from.x, corner.y + from.y), width, walk,
               rule);
    return;
  }
  if constexpr (F::bits == 8 && G::bits == 8 && HasBitMask<Rule>) {
    if (walk == Walk::forwards) {
      const linear::Rect& corner = source.bounds();
      const linear::Rect& of_mask = rule.mask.bounds();
      blit_bytes_masked(target.byte_at(at.x, at.y), source.byte_at(corner.x + from.x, corner.y + from.y),
                        width, rule.mask, of_mask.x + from.x, of_mask.y + from.y, rule.rule);
      return;
    }
  }
  const int step = walk == Walk::backwards ? -1 : 1;
  int column = walk == Walk::backwards ? width - 1 : 0;
  for (int left = width; left > 0; --left, column += step)
    show_pixel(target, at.x + column, at.y, source, from.x + column, from.y, rule);
}

}  // namespace detail

/// Copies `source` so that the corner of its bounds lands on `position`, in the coordinates of `target`.
/// Errors: position (outside the domain), rectangle (the clip is), colour (a key that the source's format
/// can't hold), table (shorter than the source's format asks for, or with an entry that the target's can't
/// hold), source (overlaps the target in another format or stride), mask (mismatched: it isn't as large as
/// the source, or its memory meets that of the target inside `clip`). Nothing is drawn on error.
template <PixelFormat F, PixelFormat G, class Byte, class Rule = Everything>
requires(Rule::template converts<F, G>) Status
    blit(const Surface<F>& target, linear::Point position, const PixelView<G, Byte>& source,
         const Rule& rule = {}, const linear::Rect& clip = everywhere)
noexcept {
  if (!linear::in_domain(position)) return {Error::out_of_domain, Argument::position};
  if (!linear::in_domain(clip)) return {Error::out_of_domain, Argument::rectangle};
  if (const Status status = detail::check_rule<F>(rule, source); !status.ok()) return status;
  const linear::Rect placed{position.x, position.y, source.size().width, source.size().height};
  const linear::Rect part = linear::intersect(linear::intersect(placed, target.bounds()), clip);
  if (part.empty()) return {};

  const Picture<G> picture = source;
  const linear::Point from{picture.bounds().x + (part.x - position.x),
                           picture.bounds().y + (part.y - position.y)};
  const detail::Walk walk =
      detail::walk_between(target, {part.x, part.y}, picture, from, {part.width, part.height});
  if (walk == detail::Walk::impossible) return {Error::mismatched, Argument::source};
  if (detail::meets_mask(rule, target, part)) return {Error::mismatched, Argument::mask};

  const int step = walk == detail::Walk::backwards ? -1 : 1;
  int row = walk == detail::Walk::backwards ? part.height - 1 : 0;
  for (int left = part.height; left > 0; --left, row += step) {
    const linear::Point to_row{part.x, part.y + row};
    const linear::Point from_row{from.x, from.y + row};
    if constexpr (detail::moves_rows<F, G, Rule>)
      detail::move_row(target, to_row, picture, from_row, part.width, walk, rule);
    else
      detail::blit_row(target, to_row, picture, {part.x - position.x, part.y - position.y + row}, part.width,
                       walk, rule);
  }
  return {};
}

}  // namespace intaglio::image
