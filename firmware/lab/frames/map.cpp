// SPDX-License-Identifier: MIT
//
// The map and its knobs.
#include <firmware/apps/map/map.hpp>
#include <firmware/lab/frames/programs.hpp>

namespace lab::frames {
namespace {

using namespace apps::map;

constinit bool codes = false;

struct TurnedMixing {
  apps::Rgb operator()(apps::Rgb from, apps::Rgb to, int part, int whole) const noexcept {
    return codes ? apps::MixCodes{}(from, to, part, whole) : apps::MixLight{}(from, to, part, whole);
  }
};

// The program's knobs as variables.
struct TurnedKnobs {
  using Mixing = TurnedMixing;
  static inline constinit int shortest = 0;
  static inline constinit int surf = 0;
  static inline constinit int zone_stride = 1;
};

constexpr std::array<std::string_view, 2> mixing_names{"codes", "light"};
constexpr std::array<int, 5> shortest_choices{0, 128, 256, 512, 1024};
constexpr std::array<std::string_view, 5> shortest_names{"0", "1/2", "1", "2", "4"};
constexpr std::array<int, 3> surf_choices{0, 2, 4};
constexpr std::array<std::string_view, 3> surf_names{"0", "2", "4"};
constexpr std::array<int, 3> stride_choices{1, 4, 16};
constexpr std::array<std::string_view, 3> stride_names{"1", "4", "16"};

constexpr std::array<Knob, 4> knobs{{
    {"Mixing", mixing_names, 1, 1, "how day becomes night: codes of colours are mixed, or their light"},
    {"shortest", shortest_names, 0, 0, "vertices nearer to the last one, in pixels, are left out"},
    {"surf", surf_names, 2, 2, "lines of light water and of shadow along the shores"},
    {"zone_stride", stride_names, 0, 0, "bands of latitude that share a colour"},
}};
static_assert(shortest_choices[0] == DefaultKnobs::shortest && surf_choices[2] == DefaultKnobs::surf &&
              stride_choices[0] == DefaultKnobs::zone_stride);

// Land's area; its shores; the palette.
constexpr std::array<Part, 3> parts{{{1, 3}, {1, 2}, {0}}};
constexpr Settings settings = counted_settings(knobs, parts);

void turn(const Setting& setting) noexcept {
  codes = setting[0] == 0;
  TurnedKnobs::shortest = shortest_choices[setting[1]];
  TurnedKnobs::surf = surf_choices[setting[2]];
  TurnedKnobs::zone_stride = stride_choices[setting[3]];
}

template <class Knobs>
using App = TunedMap<intaglio::image::Indexed8, Knobs>;

}  // namespace

// As it is, the map is at its finest.
Scene map() noexcept {
  return {"map", knobs, parts, settings, {Stage<App<TurnedKnobs>>::program(), map_as_it_is(), map_as_it_is()},
          turn};
}

}  // namespace lab::frames
