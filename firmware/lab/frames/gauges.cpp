// SPDX-License-Identifier: MIT
//
// The instruments and their knobs.
#include <intaglio/number/type_name.hpp>

#include <firmware/apps/gauges/gauges.hpp>
#include <firmware/lab/frames/programs.hpp>
#include <type_traits>

namespace lab::frames {
namespace {

using namespace apps::gauges;
using intaglio::number::Angle;
using intaglio::number::Family;
using intaglio::number::Fixed;
using intaglio::number::SineFamily;

constinit Setting chosen{};

template <class... R>
Fixed<15> sine_by(Family<R...> /*rungs*/, Angle angle) noexcept {
  int rung = chosen[0];
  Fixed<15> value{};
  (void)((rung-- == 0 && (value = R{}(angle), true)) || ...);
  return value;
}

struct TurnedSine {
  static constexpr auto bound = DefaultKnobs::Sine::bound;
  Fixed<15> operator()(Angle angle) const noexcept { return sine_by(SineFamily{}, angle); }
};

struct TurnedMixing {
  apps::Rgb operator()(apps::Rgb from, apps::Rgb to, int part, int whole) const noexcept {
    return chosen[1] == 0 ? apps::MixCodes{}(from, to, part, whole) : apps::MixLight{}(from, to, part, whole);
  }
};

constexpr std::array<int, 4> wedge_choices{16, 32, 64, 128};
constexpr std::array<int, 4> step_choices{1, 4, 8, 12};

// The program's knobs as variables.
struct TurnedKnobs {
  using Sine = TurnedSine;
  using Mixing = TurnedMixing;
  static constexpr int edge_steps = FinestKnobs::edge_steps;
  static inline constinit int wedges = 0;
  static inline constinit int face_steps = 0;
  static inline constinit Edges edges = Edges::hard;
  static const auto& inks() noexcept {
    return chosen[1] == 0 ? ink::table<apps::MixCodes, edge_steps> : ink::table<apps::MixLight, edge_steps>;
  }
};

void turn(const Setting& setting) noexcept {
  chosen = setting;
  TurnedKnobs::wedges = wedge_choices[setting[2]];
  TurnedKnobs::face_steps = step_choices[setting[3]];
  TurnedKnobs::edges = static_cast<Edges>(setting[4]);
}

// Where the rung is in the list, and which is the most accurate.
template <class Wanted, class... R>
constexpr int index_of(Family<R...> /*rungs*/) noexcept {
  int index = 0;
  (void)((std::is_same_v<Wanted, R> || (++index, false)) || ...);
  return index;
}
template <class... R>
constexpr int finest_of(Family<R...> /*rungs*/) noexcept {
  constexpr std::array<int, sizeof...(R)> bounds{R::bound.thousandths...};
  return static_cast<int>(std::min_element(bounds.begin(), bounds.end()) - bounds.begin());
}
template <class... R>
constexpr std::array<std::string_view, sizeof...(R)> names_of(Family<R...> /*rungs*/) noexcept {
  return {intaglio::number::type_name<R>()...};
}

constexpr auto sine_names = names_of(SineFamily{});
constexpr std::array<std::string_view, 2> mixing_names{"codes", "light"};
constexpr std::array<std::string_view, 4> wedge_names{"16", "32", "64", "128"};
constexpr std::array<std::string_view, 4> step_names{"1", "4", "8", "12"};
constexpr std::array<std::string_view, 4> edge_names{"hard", "2x2", "4x4", "area"};

constexpr int usual_sine = index_of<DefaultKnobs::Sine>(SineFamily{});
constexpr std::array<Knob, 5> knobs{{
    {"Sine", sine_names, usual_sine, finest_of(SineFamily{}), "what places everything that turns"},
    {"Mixing", mixing_names, 1, 1, "how colours fade and glow: their codes are mixed, or their light"},
    {"wedges", wedge_names, 2, 3, "wedges that a bezel's metal is made of"},
    {"face_steps", step_names, 3, 3, "discs that a dial's face is shaded with"},
    {"edges", edge_names, 0, 3, "edges of needles and ticks: hard, by samples, by exact area"},
}};
static_assert(knobs[0].finest == index_of<FinestKnobs::Sine>(SineFamily{}));
static_assert(wedge_choices[2] == DefaultKnobs::wedges && wedge_choices[3] == FinestKnobs::wedges);
static_assert(step_choices[3] == DefaultKnobs::face_steps && step_choices[3] == FinestKnobs::face_steps);
// The bezels; needles and ticks; faces; the palette.
constexpr std::array<Part, 4> parts{{{0, 2}, {0, 4}, {3}, {1}}};
constexpr Settings settings = counted_settings(knobs, parts);

template <class Knobs>
using App = TunedGauges<intaglio::image::Indexed8, Knobs>;

}  // namespace

Scene gauges() noexcept {
  return {"gauges",
          knobs,
          parts,
          settings,
          {Stage<App<TurnedKnobs>>::program(), gauges_as_it_is(), gauges_finest()},
          turn};
}

}  // namespace lab::frames
