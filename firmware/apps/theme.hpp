// SPDX-License-Identifier: MIT
//
// Inks: what a program calls its colours, and which palette index each of them is on this screen.
//
// Rule: inks are numbered by importance. A screen with n loadable entries gets the first n inks as its
// palette, entry i for ink i; every other ink is the nearest of those. On a screen with a fixed palette every
// ink is the nearest entry. "Nearest" is by brightness (`tone`) where the entries have no colour, by weighted
// RGB distance where they have; with two entries an ink is the brighter one iff its tone is at least 128.
//
// So an ink that owns its entry changes colour by the palette alone, and no pixel is touched; an ink that
// doesn't gets another index. `set` and `fade` hide which of the two happened.
//
// Bit budget: a distance is at most (2+4+1) * 255^2 < 2^19.
#pragma once

#include <intaglio/image/palette.hpp>
#include <intaglio/image/ramp.hpp>
#include <intaglio/present/screen_info.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace apps {

using intaglio::image::mix;
using intaglio::image::Rgb;

/// A colour, and how bright it is on a screen without colours. The two differ where a colour means something:
/// a red zone has to stand out from its grey neighbourhood, too.
struct Ink {
  Rgb colour{};
  std::uint8_t tone = 0;
};

/// Steps of a fade: 0 is black, `fade_full` leaves a colour as it is.
inline constexpr int fade_full = 256;

/// An ink of one colour whose tone is the colour's luma.
[[nodiscard]] constexpr Ink plain(Rgb c) noexcept {
  return {c, static_cast<std::uint8_t>((c.r * 77 + c.g * 150 + c.b * 29) / 256)};
}

/// Mixes colours as light: exactly what is seen between them.
struct MixLight {
  [[nodiscard]] constexpr Rgb operator()(Rgb from, Rgb to, int part, int whole) const noexcept {
    return mix(from, to, part, whole);
  }
};

/// Mixes the codes of colours: cheaper, and darker between them than what is seen.
struct MixCodes {
  [[nodiscard]] constexpr Rgb operator()(Rgb from, Rgb to, int part, int whole) const noexcept {
    if (part <= 0) return from;
    if (part >= whole) return to;
    const auto between = [=](int a, int b) {
      return static_cast<std::uint8_t>((a * (whole - part) + b * part + whole / 2) / whole);
    };
    return {between(from.r, to.r), between(from.g, to.g), between(from.b, to.b)};
  }
};

/// `from` at 0, `to` at `whole` (1 .. 2^14): colours are mixed as `Mixing` does, tones in equal steps.
template <class Mixing = MixLight>
[[nodiscard]] constexpr Ink mix(Ink from, Ink to, int part, int whole) noexcept {
  return {Mixing{}(from.colour, to.colour, part, whole),
          static_cast<std::uint8_t>((from.tone * (whole - part) + to.tone * part) / whole)};
}

/// The inks of a program on a screen. `Inks` is their number, `Entries` (2, 4, 16, 256) what the pixel format
/// can name, `Mixing` how colours fade.
template <int Inks, int Entries, class Mixing = MixLight>
class Theme {
 public:
  /// `inks` by importance. A fixed palette without colours given is a ramp from black to white.
  Theme(const std::array<Ink, std::size_t{Inks}>& inks, const intaglio::present::ScreenInfo& screen) noexcept
      : inks_(inks), loadable_(screen.palette_entries > 0) {
    if (loadable_) {
      count_ = screen.palette_entries < Entries ? screen.palette_entries : Entries;
      const int own = count_ < Inks ? count_ : Inks;
      for (int entry = 0; entry < own; ++entry) entries_[at(entry)] = inks_[at(entry)];
    } else {
      read_fixed(screen.fixed_palette);
    }
    for (int entry = 0; entry < count_; ++entry) {
      const Rgb c = entries_[at(entry)].colour;
      if (c.r != c.g || c.g != c.b) coloured_ = true;
    }
    for (int ink = 0; ink < Inks; ++ink) choose(ink);
    fade(fade_full);
  }

  /// True if the ink changes colour by its palette entry alone.
  [[nodiscard]] bool owns_entry(int ink) const noexcept { return loadable_ && ink < count_; }

  /// True if there is nothing but on and off.
  [[nodiscard]] bool two_tone() const noexcept { return count_ == 2; }

  /// The palette index of an ink, 0 <= ink < Inks.
  [[nodiscard]] unsigned index(int ink) const noexcept { return index_[at(ink)]; }

  /// The ink is another colour from now on.
  void set(int ink, Ink value) noexcept {
    inks_[at(ink)] = value;
    if (owns_entry(ink))
      entries_[at(ink)] = value;
    else
      choose(ink);
  }

  /// How much of every colour is seen, 0 .. fade_full; call it after the `set`s of a frame. Screens with two
  /// entries don't fade: there is nothing between on and off.
  void fade(int level) noexcept {
    if (loadable_) {
      for (int entry = 0; entry < count_; ++entry)
        shown_.set(entry, Mixing{}(Rgb{}, entries_[at(entry)].colour, level, fade_full)).ignore();
    } else if (level != level_ && count_ > 2) {
      level_ = level;
      for (int ink = 0; ink < Inks; ++ink) choose(ink);
    }
  }

  /// The bytes to load, RGB each; none where the palette is fixed.
  [[nodiscard]] std::span<const std::uint8_t> palette() const noexcept {
    return loadable_ ? shown_.bytes().first(at(count_) * 3U) : std::span<const std::uint8_t>{};
  }

 private:
  static constexpr std::size_t at(int i) noexcept { return static_cast<std::size_t>(i); }

  void read_fixed(std::span<const std::uint8_t> bytes) noexcept {
    const auto given = static_cast<int>(bytes.size() / 3U < at(Entries) ? bytes.size() / 3U : at(Entries));
    count_ = given >= 2 ? given : Entries;
    for (int entry = 0; entry < count_; ++entry) {
      const auto grey = static_cast<std::uint8_t>(entry * 255 / (Entries - 1));
      const std::size_t first = at(entry) * 3U;
      entries_[at(entry)] =
          given >= 2 ? plain({bytes[first], bytes[first + 1], bytes[first + 2]}) : plain({grey, grey, grey});
    }
  }

  void choose(int ink) noexcept {
    if (owns_entry(ink)) {
      index_[at(ink)] = static_cast<std::uint8_t>(ink);
      return;
    }
    const Ink wanted = mix<Mixing>(Ink{}, inks_[at(ink)], loadable_ ? fade_full : level_, fade_full);
    if (count_ == 2) {
      const bool second_is_brighter = entries_[1].tone > entries_[0].tone;
      index_[at(ink)] = (wanted.tone >= 128) == second_is_brighter ? 1 : 0;
      return;
    }
    int best = 0;
    int least = distance(wanted, entries_[0]);
    for (int entry = 1; entry < count_ && entry < (loadable_ ? Inks : Entries); ++entry) {
      const int d = distance(wanted, entries_[at(entry)]);
      if (d < least) {
        least = d;
        best = entry;
      }
    }
    index_[at(ink)] = static_cast<std::uint8_t>(best);
  }

  [[nodiscard]] int distance(Ink a, Ink b) const noexcept {
    if (!coloured_) return a.tone > b.tone ? a.tone - b.tone : b.tone - a.tone;
    const int dr = a.colour.r - b.colour.r;
    const int dg = a.colour.g - b.colour.g;
    const int db = a.colour.b - b.colour.b;
    return 2 * dr * dr + 4 * dg * dg + db * db;
  }

  std::array<Ink, std::size_t{Inks}> inks_;
  std::array<Ink, std::size_t{Entries}> entries_{};  ///< What the screen shows at full brightness.
  std::array<std::uint8_t, std::size_t{Inks}> index_{};
  intaglio::image::Palette<Entries> shown_{};
  int count_ = Entries;
  int level_ = fade_full;
  bool loadable_;
  bool coloured_ = false;
};

}  // namespace apps
