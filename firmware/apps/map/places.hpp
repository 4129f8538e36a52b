// SPDX-License-Identifier: MIT
//
// Cities to mark on the map.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace apps::map {

/// A city.
struct City {
  std::string_view name;   ///< UTF-8
  std::int16_t longitude;  ///< 1/100 degree, east
  std::int16_t latitude;   ///< 1/100 degree, north
};

inline constexpr std::array<City, 58> cities{{
    {"London", -13, 5151},
    {"Paris", 235, 4886},
    {"Roma", 1250, 4190},
    {"Madrid", -370, 4042},
    {"Berlin", 1340, 5252},
    {"Athína", 2373, 3798},
    {"Istanbul", 2898, 4101},
    {"Cairo", 3124, 3004},
    {"Moskva", 3762, 5575},
    {"Baghdad", 4437, 3331},
    {"Tehran", 5139, 3569},
    {"Riyadh", 4668, 2471},
    {"Dubai", 5527, 2520},
    {"Karachi", 6700, 2486},
    {"Mumbai", 7288, 1908},
    {"Delhi", 7710, 2870},
    {"Dhaka", 9041, 2381},
    {"Bangkok", 10050, 1376},
    {"Singapore", 10382, 135},
    {"Jakarta", 10685, -621},
    {"Manila", 12098, 1460},
    {"Hong Kong", 11417, 2232},
    {"Shanghai", 12147, 3123},
    {"Seoul", 12698, 3757},
    {"Tokyo", 13969, 3569},
    {"Osaka", 13550, 3469},
    {"Sapporo", 14135, 4306},
    {"Sydney", 15121, -3387},
    {"Auckland", 17476, -3685},
    {"Wellington", 17478, -4129},
    {"Anchorage", -14990, 6122},
    {"Nome", -16541, 6450},
    {"San Francisco", -12242, 3777},
    {"Los Angeles", -11824, 3405},
    {"Chicago", -8763, 4188},
    {"New York", -7401, 4071},
    {"Miami", -8019, 2576},
    {"La Habana", -8237, 2311},
    {"México", -9913, 1943},
    {"Caracas", -6690, 1048},
    {"Bogotá", -7407, 471},
    {"Lima", -7704, -1205},
    {"Rio de Janeiro", -4317, -2291},
    {"Buenos Aires", -5838, -3460},
    {"Santiago", -7067, -3345},
    {"Ushuaia", -6830, -5480},
    {"Punta Arenas", -7091, -5316},
    {"Dakar", -1744, 1469},
    {"Lagos", 338, 652},
    {"Nairobi", 3682, -129},
    {"Johannesburg", 2804, -2620},
    {"Cape Town", 1842, -3393},
    {"Dublin", -626, 5335},
    {"Oslo", 1075, 5991},
    {"Reykjavík", -2194, 6415},
    {"Tunis", 1018, 3681},
    {"Napoli", 1425, 4085},
    {"Beograd", 2046, 4479},
}};

}  // namespace apps::map
