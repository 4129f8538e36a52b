// SPDX-License-Identifier: MIT
//
// Whole frames: the programs of firmware/apps, with their knobs, as the lab counts and pictures them.
//
// Rule: a scene is a program at 320x240 pixels of 8 bits with 256 palette entries, a list of knobs, and
// *settings*: a choice for each knob. A program's knobs are constants of its type; here they are variables,
// so that one copy of the program has all settings. The standard and the finest setting are there as
// constants, too, each alone in its file as in a board's image: they show what variables cost more.
//
// All settings are more than can be counted. But a frame is made of parts, and each part asks a few of the
// knobs; knobs that no part asks together can't change what the other costs. So counted are all combinations
// of the knobs of each part, the others as in the standard setting: what any setting costs is a sum of such
// counts, to the instruction. The finest setting and some that look random are counted to hold that sum to.
#pragma once

#include <intaglio/image/format.hpp>
#include <intaglio/image/surface.hpp>
#include <intaglio/linear/rect.hpp>
#include <intaglio/present/screen_info.hpp>
#include <intaglio/status.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <firmware/lab/family.hpp>
#include <initializer_list>
#include <memory>
#include <span>
#include <string_view>

namespace lab::frames {

inline constexpr intaglio::linear::Size size{320, 240};
inline constexpr intaglio::present::ScreenInfo screen{size, 256, {}};
/// The frames that are looked at: for the instruments a fade, the self-test and a drive; for the map far and
/// near, by day and by night.
inline constexpr std::array<std::uint32_t, 8> looked_at{15, 57, 100, 200, 420, 750, 1100, 1399};

/// Something to turn.
struct Knob {
  std::string_view name;
  std::span<const std::string_view> choices;
  int standard = 0;  ///< The choice of the program as it is.
  int finest = 0;    ///< The most accurate.
  std::string_view explained{};
};

inline constexpr std::size_t most_knobs = 6;
/// Knobs that a part of the program asks, by their numbers.
struct Part {
  std::array<std::uint8_t, most_knobs> knobs{};
  std::size_t count = 0;

  constexpr Part(std::initializer_list<int> numbers) noexcept {
    for (const int number : numbers) knobs[count++] = static_cast<std::uint8_t>(number);
  }
};
/// A choice for each knob.
using Setting = std::array<std::uint8_t, most_knobs>;

/// The settings that are counted.
struct Settings {
  std::array<Setting, 128> list{};
  int count = 0;

  constexpr void add(const Setting& setting) noexcept {
    for (int i = 0; i < count; ++i)
      if (list[static_cast<std::size_t>(i)] == setting) return;
    list[static_cast<std::size_t>(count++)] = setting;
  }
};

[[nodiscard]] constexpr Setting standard_setting(std::span<const Knob> knobs) noexcept {
  Setting setting{};
  for (std::size_t k = 0; k < knobs.size(); ++k) setting[k] = static_cast<std::uint8_t>(knobs[k].standard);
  return setting;
}

/// On to the next combination of the choices of some knobs; false after the last.
[[nodiscard]] constexpr bool next_combination(std::span<const Knob> knobs,
                                              std::span<const std::uint8_t> turned,
                                              Setting& setting) noexcept {
  for (const std::size_t k : turned) {
    setting[k] = static_cast<std::uint8_t>(setting[k] + 1U);
    if (setting[k] < knobs[k].choices.size()) return true;
    setting[k] = 0;
  }
  return false;
}

/// The standard setting, all combinations within a part, the finest, and some more. Each knob is in a part.
[[nodiscard]] constexpr Settings counted_settings(std::span<const Knob> knobs,
                                                  std::span<const Part> parts) noexcept {
  constexpr int checks = 8;
  Settings settings;
  const Setting standard = standard_setting(knobs);
  settings.add(standard);
  for (const Part& part : parts) {
    const std::span<const std::uint8_t> turned(part.knobs.data(), part.count);
    Setting setting = standard;
    for (const std::size_t k : turned) setting[k] = 0;
    do settings.add(setting);
    while (next_combination(knobs, turned, setting));
  }
  Setting finest{};
  for (std::size_t k = 0; k < knobs.size(); ++k) finest[k] = static_cast<std::uint8_t>(knobs[k].finest);
  settings.add(finest);
  Random random(1);
  for (int i = 0; i < checks; ++i) {
    Setting any{};
    for (std::size_t k = 0; k < knobs.size(); ++k)
      any[k] = static_cast<std::uint8_t>(random.between(0, static_cast<int>(knobs[k].choices.size()) - 1));
    settings.add(any);
  }
  return settings;
}

/// What scenes draw on.
[[nodiscard]] intaglio::image::Surface<intaglio::image::Indexed8> canvas() noexcept;

/// Room for one program.
inline constexpr std::size_t room_bytes = std::size_t{144} * 1024;
[[nodiscard]] void* room() noexcept;

/// A program as it lies in an image: what begins it in the room, a frame of it, and that frame's colours.
struct Program {
  void (*start)() noexcept = nullptr;
  intaglio::Status (*draw)(std::uint32_t frame) noexcept = nullptr;
  std::span<const std::uint8_t> (*palette)() noexcept = nullptr;
};

/// A program in the room. What is to be counted as a board runs it is made in a file of its own: the compiler
/// inlines a function into its only caller, but not into two, so beside another copy of the program it would
/// be dearer.
template <class App>
class Stage {
 public:
  static_assert(sizeof(App) <= room_bytes);
  [[nodiscard]] static constexpr Program program() noexcept { return {&start, &draw, &palette}; }

 private:
  static void start() noexcept { app = std::construct_at(static_cast<App*>(room()), screen); }
  static intaglio::Status draw(std::uint32_t frame) noexcept {
    app->update(frame);
    return app->draw(canvas());
  }
  static std::span<const std::uint8_t> palette() noexcept { return app->palette(); }

  static inline constinit App* app = nullptr;
};

namespace detail {
/// Which program is in the room.
inline constinit Program in_room{};
}  // namespace detail

/// A program to look at.
struct Scene {
  std::string_view name;
  std::span<const Knob> knobs{};
  std::span<const Part> parts{};
  Settings settings{};
  /// With its knobs as variables, with them as constants, and with those at their finest.
  std::array<Program, 3> programs{};
  /// Sets the knobs that are variables.
  void (*turn)(const Setting& setting) noexcept = nullptr;

  /// Begins with a setting; `fixed`: 0 takes its choices, 1 is the program with its knobs as constants, 2 the
  /// finest.
  void start(const Setting& setting, int fixed) const noexcept {
    if (turn != nullptr) turn(setting);
    detail::in_room = programs[static_cast<std::size_t>(fixed)];
    detail::in_room.start();
  }
  /// A frame on `canvas()` of what has begun: this is what is counted.
  [[nodiscard]] intaglio::Status draw(std::uint32_t frame) const noexcept {
    return detail::in_room.draw(frame);
  }
  /// The colours of that frame.
  [[nodiscard]] std::span<const std::uint8_t> palette() const noexcept { return detail::in_room.palette(); }

  /// How many variants there are as constants: the standard one, and with knobs the finest.
  [[nodiscard]] constexpr int fixed_count() const noexcept { return knobs.empty() ? 1 : 2; }
  /// How many variants are counted: first those as constants, then the settings.
  [[nodiscard]] constexpr int variants() const noexcept {
    return fixed_count() + (knobs.empty() ? 0 : settings.count);
  }
  /// Begins with a variant.
  void start_variant(int variant) const noexcept {
    const int setting = variant - fixed_count();
    start(settings.list[static_cast<std::size_t>(setting < 0 ? 0 : setting)], setting < 0 ? variant + 1 : 0);
  }
};

/// All scenes. They share a canvas and the room that a program lives in.
[[nodiscard]] std::span<const Scene> scenes() noexcept;

/// A scene without knobs.
template <class App>
[[nodiscard]] constexpr Scene plain_scene(std::string_view name) noexcept {
  constexpr Program program = Stage<App>::program();
  return {name, {}, {}, {}, {program, program, program}};
}

}  // namespace lab::frames
