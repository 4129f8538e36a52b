// SPDX-License-Identifier: MIT
//
// The words of the drawing language that choose how a primitive is drawn.
#pragma once

#include <host/draw/canvas.hpp>
#include <host/draw/sprite.hpp>
#include <intaglio/raster/stroke.hpp>
#include <intaglio/text/aligned_lines.hpp>

#include <array>
#include <string_view>
#include <utility>

namespace host::draw {

// The methods that draw a primitive; the first is what it takes without being told.
inline constexpr auto line_methods =
    std::to_array<std::pair<std::string_view, LineMethod>>({{"exact", LineMethod::exact},
                                                            {"line1", LineMethod::line1},
                                                            {"line2", LineMethod::line2},
                                                            {"distance", LineMethod::distance}});
inline constexpr auto thick_line_methods = std::to_array<std::pair<std::string_view, ThickLineMethod>>(
    {{"across", ThickLineMethod::across}, {"minor", ThickLineMethod::minor}});
inline constexpr std::array<std::pair<std::string_view, TriangleMethod>, 3> triangle_methods{
    {{"walk", TriangleMethod::walk}, {"box", TriangleMethod::box}, {"blocks", TriangleMethod::blocks}}};
inline constexpr std::array<std::pair<std::string_view, PolygonMethod>, 3> polygon_methods{
    {{"active", PolygonMethod::active},
     {"basic", PolygonMethod::basic},
     {"critical", PolygonMethod::critical}}};

inline constexpr auto joins = [] {
  using intaglio::raster::Join;
  return std::to_array<std::pair<std::string_view, Join>>(
      {{"miter", Join::miter}, {"bevel", Join::bevel}, {"round", Join::round}});
}();
inline constexpr auto caps = [] {
  using intaglio::raster::Cap;
  return std::to_array<std::pair<std::string_view, Cap>>(
      {{"butt", Cap::butt}, {"square", Cap::square}, {"round", Cap::round}});
}();

inline constexpr auto alignments = [] {
  using intaglio::text::Alignment;
  return std::to_array<std::pair<std::string_view, Alignment>>(
      {{"left", Alignment::left}, {"centre", Alignment::centre}, {"right", Alignment::right}});
}();
inline constexpr auto baselines = [] {
  using intaglio::text::Baseline;
  return std::to_array<std::pair<std::string_view, Baseline>>({{"top", Baseline::top},
                                                               {"middle", Baseline::middle},
                                                               {"baseline", Baseline::alphabetic},
                                                               {"bottom", Baseline::bottom}});
}();

// For sprites that are turned, and that are stretched.
inline constexpr auto turning_methods =
    std::to_array<std::pair<std::string_view, SpriteMethod>>({{"zoom", SpriteMethod::zoom},
                                                              {"shear", SpriteMethod::shear},
                                                              {"bilinear", SpriteMethod::turn_bilinear}});
inline constexpr auto stretching_methods =
    std::to_array<std::pair<std::string_view, SpriteMethod>>({{"nearest", SpriteMethod::stretch},
                                                              {"bilinear", SpriteMethod::stretch_bilinear},
                                                              {"box", SpriteMethod::stretch_box}});
inline constexpr auto dither_methods =
    std::to_array<std::pair<std::string_view, DitherMethod>>({{"none", DitherMethod::none},
                                                              {"bayer2", DitherMethod::bayer2},
                                                              {"bayer4", DitherMethod::bayer4},
                                                              {"bayer8", DitherMethod::bayer8},
                                                              {"threetap", DitherMethod::three_tap},
                                                              {"fourtap", DitherMethod::four_tap},
                                                              {"serpentine", DitherMethod::serpentine}});

}  // namespace host::draw
