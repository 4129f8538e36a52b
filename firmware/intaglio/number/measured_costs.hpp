// SPDX-License-Identifier: MIT
//
// What each rung costs on each core: made by `intaglio-lab accept` from host/lab/baseline/accuracy.csv.
//
// Hundredths of an instruction a call (of drawing, also a pixel or what else its family is counted by), on
// cortex-m0plus, cortex-m3, cortex-m4, cortex-m7, arm926, rv32imac, x86-64, under the family's first load.
// Only programs that ask (cheapest.hpp) see it, and only while they are compiled.
#pragma once

#include <intaglio/number/core.hpp>

#include <array>

namespace intaglio::number {

// clang-format off
inline constexpr std::array<MeasuredCost, 10> measured_costs{{
    // flood-fill: empty chambers
    {"SpanFlood", {21522050, 9947200, 9988200, 9976000, 9008200, 8455750, 8621650}},
    {"PixelStackFlood", {89800050, 33948300, 33948300, 33948300, 49294000, 28352250, 40410300}},
    {"SweepFlood", {172745050, 47835300, 47835400, 41616100, 176783900, 33505450, 44990300}},
    // polygon-clip: 6 vertices
    {"SutherlandHodgman", {2717500, 717150, 721038, 765850, 1119838, 917600, 628338}},
    {"GreinerHormann", {7132812, 1523550, 1525525, 1611525, 1731875, 1545475, 1862400}},
    {"CutAndClassify", {43594662, 8726075, 8850950, 8679350, 9702338, 10116738, 9131788}},
    // polygon-fill: triangles to pentagons
    {"ScanlineFill", {1208762, 832569, 821206, 833319, 880925, 959456, 1009338}},
    {"CriticalPointsFill", {1438200, 1098069, 1100806, 1090950, 1074906, 1115862, 1145938}},
    {"BasicFill", {5888762, 2408088, 2475600, 2420388, 3249662, 2706062, 2618969}},
    // sine: any angle
    {"SineTable256Linear", {2831, 1518, 1701, 1601, 1901, 2514, 2262}},
}};
// clang-format on

}  // namespace intaglio::number
