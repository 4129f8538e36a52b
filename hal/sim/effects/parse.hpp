// SPDX-License-Identifier: MIT
//
// Effects as a user names them: "bus,te=60.2hz+200us,response=8ms,dead=12:7".
//
// Rule: names between commas, each at most once (`dead` as often as there are such pixels), with or without a
// value; without one, the panel's own. Times are decimal numbers with ns, us, ms or s, rates with Hz, kHz or
// MHz, of any case; they are read exactly.
#pragma once

#include <hal/sim/catalog.hpp>

#include <span>
#include <string>
#include <string_view>
#include <variant>

namespace hal::sim {

/// What a user can be told of an effect.
struct EffectHelp {
  std::string_view name;
  std::string_view value;  ///< How its value is written; in brackets if it can be left out.
  std::string_view does;
};

/// All effects, in the order in which they act.
[[nodiscard]] std::span<const EffectHelp, effect_count> effect_help();

/// The effects that a text names on a panel, or what is wrong with it.
[[nodiscard]] std::variant<Effects, std::string> parse_effects(std::string_view text, const PanelSpec& panel);

/// What an effect is on a panel where it is named without a value, as in "10 MHz, 2 us a window"; empty if
/// there is nothing to tell, or it is the same on all panels.
[[nodiscard]] std::string effect_default(Effect effect, const PanelSpec& panel);

}  // namespace hal::sim
