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
inline constexpr std::array<MeasuredCost, 60> measured_costs{{
    // circle: radius up to 16
    {"CursorCircle", {81231, 50141, 50725, 46131, 50384, 46819, 48553}},
    {"MidpointCircle32", {414428, 292681, 287519, 291906, 287619, 277562, 306628}},
    {"MidpointCircle16", {420884, 294731, 289956, 296631, 296969, 287900, 306728}},
    {"MidpointCircle64", {437616, 300716, 295553, 301453, 297128, 291744, 306728}},
    {"SineCircle", {733756, 485569, 477628, 486706, 508606, 475875, 524050}},
    // edge: 240 rows, whole pixels
    {"TruncatedSlope", {1355, 621, 621, 621, 743, 728, 818}},
    {"RoundedSlope", {1265, 622, 622, 623, 745, 732, 821}},
    {"ExactEdge", {1413, 1027, 1027, 937, 933, 948, 947}},
    // ellipse: half axes up to 15
    {"MidpointEllipse32", {438984, 268503, 268603, 268900, 271475, 250884, 302853}},
    {"MidpointEllipse16", {453791, 279091, 278441, 282709, 297244, 275681, 307606}},
    {"RowEllipse", {882344, 484122, 486959, 508891, 500547, 522544, 431988}},
    {"MidpointEllipse64", {486369, 295500, 295262, 294072, 294912, 295634, 303753}},
    {"SineEllipse", {681228, 399616, 399716, 399622, 431359, 406031, 458159}},
    // flood-fill: empty chambers
    {"SpanFlood", {21522050, 9947200, 9988200, 9976000, 9008200, 8455750, 8621650}},
    {"PixelStackFlood", {89800050, 33948300, 33948300, 33948300, 49294000, 28352250, 40410300}},
    {"SweepFlood", {172745050, 47835300, 47835400, 41616100, 176783900, 33505450, 44990300}},
    // line: short, up to 16 pixels
    {"SplitErrorLine", {163272, 46178, 45978, 46861, 100592, 53150, 44286}},
    {"ExactLine", {35136, 24908, 25108, 24709, 24931, 26059, 25064}},
    {"SubPixelLine", {72817, 33347, 33147, 32434, 34045, 35594, 33855}},
    {"RoundedLine", {132308, 51480, 51280, 51214, 79755, 55030, 48123}},
    {"DistanceLine", {218130, 57545, 56639, 55262, 64167, 62242, 54891}},
    // line-clip: ends around the screen
    {"Parameters16", {149149, 23637, 23448, 23353, 73305, 30066, 13798}},
    {"Parameters32", {228241, 29530, 29530, 29541, 129120, 41346, 13966}},
    {"LiangBarsky", {654721, 93850, 94273, 95057, 315485, 126797, 54960}},
    {"CohenSutherland", {631609, 92964, 92647, 93588, 311480, 132144, 61102}},
    {"Skala", {665750, 96234, 95860, 97065, 315466, 134640, 62795}},
    // polygon-clip: 6 vertices
    {"SutherlandHodgman", {2717500, 717150, 721038, 765850, 1119838, 917600, 628338}},
    {"GreinerHormann", {7132812, 1523550, 1525525, 1611525, 1731875, 1545475, 1862400}},
    {"CutAndClassify", {43594662, 8726075, 8850950, 8679350, 9702338, 10116738, 9131788}},
    // polygon-fill: triangles to pentagons
    {"ScanlineFill", {1153738, 828312, 821969, 829444, 881688, 961744, 1013531}},
    {"CriticalPointsFill", {1438581, 1098831, 1101569, 1092094, 1075669, 1118150, 1150131}},
    {"BasicFill", {5899175, 2428912, 2496425, 2451625, 3270488, 2768538, 2733506}},
    // ramp: 16 greys, black to white
    {"MixCodes", {8138, 1301, 1301, 1301, 9520, 1201, 1901}},
    {"MixSquares", {26214, 8564, 8563, 8045, 20101, 8661, 9205}},
    {"MixTable16", {28570, 10701, 10701, 10701, 23358, 13180, 12604}},
    {"MixTable32", {112057, 15215, 15215, 15115, 65940, 20147, 12093}},
    // reciprocal: any divisor
    {"ReciprocalTable256", {4992, 1101, 1101, 1101, 1301, 2809, 1601}},
    {"ReciprocalTable256Newton", {6291, 1501, 1501, 1501, 1701, 3310, 2302}},
    {"ReciprocalTable256NewtonExact", {7993, 2501, 2501, 2501, 2601, 4411, 4004}},
    {"ReciprocalDivision", {11755, 100, 100, 100, 12978, 201, 401}},
    // reciprocal-root: any number of bits
    {"ReciprocalRootTable", {4886, 1101, 1101, 1101, 1101, 2956, 1802}},
    {"ReciprocalRootNewton", {6086, 1701, 1701, 1701, 1701, 3656, 2904}},
    {"ReciprocalRootNewton2", {12494, 2702, 2702, 2702, 2702, 4558, 4005}},
    {"ReciprocalRootNewtonExact", {40921, 5600, 5600, 5600, 5666, 7959, 5501}},
    {"ReciprocalRootDivision", {153059, 46140, 46140, 46140, 91253, 68309, 17966}},
    // sine: any angle
    {"SineTable256Nearest", {1411, 1001, 1001, 1001, 901, 1314, 1401}},
    {"SineParabola", {1712, 1100, 1100, 1100, 901, 1214, 1601}},
    {"SineParabolaCorrected", {3312, 1701, 1701, 1701, 1501, 2014, 2602}},
    {"SineBhaskara", {11910, 1400, 1400, 1400, 11394, 1614, 2304}},
    {"SineTable64Linear", {2614, 1601, 1601, 1601, 1501, 2214, 2302}},
    {"SinePolynomial5", {3314, 1802, 1802, 1802, 1902, 2115, 2704}},
    {"SineTable256Linear", {2831, 1518, 1701, 1601, 1901, 2514, 2262}},
    {"SinePolynomial7", {4214, 2102, 2102, 2102, 2102, 2518, 3205}},
    {"SineCordic", {36513, 21300, 21300, 21300, 24601, 19717, 25205}},
    // square-root: any number of bits
    {"RootTable", {4045, 1090, 1095, 1091, 1101, 2826, 1586}},
    {"RootReciprocalNewton", {6615, 2079, 2086, 2080, 2187, 3913, 3070}},
    {"RootTableDivision", {11450, 1980, 1986, 1981, 9201, 3617, 2970}},
    {"RootReciprocalNewtonExact", {7879, 2964, 2964, 2964, 3162, 4797, 4505}},
    {"RootNewtonDivision", {25124, 2433, 2433, 2433, 21850, 3862, 3640}},
    {"RootBitwise", {8978, 7241, 7241, 6514, 6535, 7345, 7011}},
}};
// clang-format on

}  // namespace intaglio::number
