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
inline constexpr std::array<MeasuredCost, 117> measured_costs{{
    // antialiasing: triangles, where one edge is in a pixel
    {"antialiasing", "NoAntialiasing", {363200, 210800, 209567, 208533, 223533, 238600, 250433}},
    {"antialiasing", "ExactArea", {2583033, 1069633, 1067600, 1067967, 1504900, 1136333, 1080533}},
    {"antialiasing", "Samples2x2", {5112233, 2418400, 2413300, 2465567, 3244300, 2570333, 3129067}},
    {"antialiasing", "Samples3x3", {6438600, 3019333, 3015400, 3095933, 5357533, 3259800, 3973433}},
    {"antialiasing", "Bartlett3x3", {6441167, 3022400, 3018967, 3099267, 5349567, 3263433, 3976167}},
    {"antialiasing", "Samples4x4", {7640200, 3544667, 3543300, 3650200, 5231833, 3870567, 4727000}},
    {"antialiasing", "Masks4x4", {11543767, 5734700, 5747267, 5665800, 6260700, 6154433, 6275767}},
    {"antialiasing", "Samples15x17", {11048000, 3758900, 3719933, 3758167, 3674467, 2894067, 3612567}},
    {"antialiasing", "PittewayWatkinson", {22866667, 4349400, 4337400, 4315733, 5291400, 4880133, 4659367}},
    // arc-tangent: any length
    {"arc-tangent", "ArcTangentLinear", {16797, 3415, 3415, 3415, 13184, 4523, 4482}},
    {"arc-tangent", "ArcTangentParabola", {17897, 4015, 4015, 4015, 13984, 5523, 5082}},
    {"arc-tangent", "ArcTangentTable128Linear", {18197, 4315, 4315, 4315, 14184, 6023, 5582}},
    {"arc-tangent", "ArcTangentPolynomial9", {21797, 7515, 7315, 7315, 17084, 9423, 7982}},
    {"arc-tangent", "ArcTangentCordic", {41539, 23874, 23874, 23874, 27259, 22970, 28028}},
    // blend16: two values
    {"blend16", "Blend16Shift", {1199, 701, 701, 701, 701, 802, 1000}},
    {"blend16", "Blend16Weight", {1200, 800, 800, 800, 800, 1002, 1400}},
    {"blend16", "Blend16TwoShiftsDown", {1199, 901, 901, 901, 901, 1102, 1300}},
    {"blend16", "Blend16TwoShifts", {1399, 801, 801, 801, 801, 1102, 1300}},
    {"blend16", "Blend16Division", {11229, 702, 702, 702, 901, 1003, 1600}},
    // blend8: two values
    {"blend8", "Blend8Shift", {1300, 700, 700, 700, 800, 901, 1000}},
    {"blend8", "Blend8WeightOneProduct", {1099, 800, 800, 800, 800, 1001, 1400}},
    {"blend8", "Blend8Weight", {1400, 800, 800, 800, 900, 1101, 1400}},
    {"blend8", "Blend8TwoShiftsDown", {1299, 900, 900, 900, 1000, 1201, 1300}},
    {"blend8", "Blend8TwoShifts", {1299, 800, 800, 800, 900, 1201, 1300}},
    {"blend8", "Blend8Division", {6464, 801, 801, 801, 901, 1001, 1201}},
    // circle: radius up to 16
    {"circle", "CursorCircle", {81231, 50141, 50725, 46131, 50384, 46819, 48553}},
    {"circle", "MidpointCircle32", {414428, 292681, 287519, 291906, 287619, 277562, 306628}},
    {"circle", "MidpointCircle16", {420884, 294731, 289956, 296631, 296969, 287900, 306728}},
    {"circle", "MidpointCircle64", {437616, 300716, 295553, 301453, 297128, 291744, 306728}},
    {"circle", "SineCircle", {733756, 485569, 477628, 486706, 508606, 475875, 524050}},
    // convex-fill: octagons up to 20 pixels
    {"convex-fill", "ScanlineFill", {466950, 300400, 298738, 301038, 325762, 336325, 342062}},
    {"convex-fill", "CriticalPointsFill", {524625, 349138, 351762, 349862, 363675, 387425, 362512}},
    {"convex-fill", "EdgeFunctionFill", {1898550, 644262, 645638, 693512, 713300, 577275, 708275}},
    {"convex-fill", "BasicFill", {1178125, 622200, 650150, 635800, 683450, 677662, 679700}},
    // dither: even greys
    {"dither", "DitherNone", {3948, 2422, 2422, 2422, 2722, 2819, 2621}},
    {"dither", "DitherOrdered2", {4551, 2941, 2941, 2941, 3544, 3141, 3436}},
    {"dither", "DitherOrdered4", {4551, 2941, 2941, 2941, 3544, 3141, 3436}},
    {"dither", "DitherOrdered8", {4551, 2941, 2941, 2941, 3544, 3141, 3436}},
    {"dither", "DitherThreeTap", {7384, 4080, 4081, 4081, 4074, 4560, 4558}},
    {"dither", "DitherFourTap", {8087, 4281, 4280, 4281, 4474, 4960, 4958}},
    {"dither", "DitherSerpentine", {8856, 4609, 4609, 4613, 4836, 5186, 5342}},
    // edge: 240 rows, whole pixels
    {"edge", "TruncatedSlope", {1355, 621, 621, 621, 743, 728, 818}},
    {"edge", "RoundedSlope", {1265, 622, 622, 623, 745, 732, 821}},
    {"edge", "ExactEdge", {1413, 1027, 1027, 937, 933, 948, 947}},
    // ellipse: half axes up to 15
    {"ellipse", "MidpointEllipse32", {438984, 268503, 268603, 268900, 271475, 250884, 302853}},
    {"ellipse", "MidpointEllipse16", {453791, 279091, 278441, 282709, 297244, 275681, 307606}},
    {"ellipse", "RowEllipse", {882344, 484122, 486959, 508891, 500547, 522544, 431988}},
    {"ellipse", "MidpointEllipse64", {486369, 295500, 295262, 294072, 294912, 295634, 303753}},
    {"ellipse", "SineEllipse", {681228, 399616, 399716, 399622, 431359, 406031, 458159}},
    // flood-fill: empty chambers
    {"flood-fill", "SpanFlood", {21522050, 9947200, 9988200, 9976000, 9008200, 8455750, 8621650}},
    {"flood-fill", "PixelStackFlood", {89800050, 33948300, 33948300, 33948300, 49294000, 28352250, 40410300}},
    {"flood-fill", "SweepFlood", {172745050, 47835300, 47835400, 41616100, 176783900, 33505450, 44990300}},
    // image-rotate: 40x30 by any angle
    {"image-rotate", "RotateNearest", {31777, 5147, 5151, 5107, 13530, 6967, 5095}},
    {"image-rotate", "RotateThreeShear", {38555, 7867, 7851, 7914, 20029, 10694, 7044}},
    {"image-rotate", "RotateBilinear", {40913, 9061, 9204, 9124, 17450, 11659, 9412}},
    // image-scale: 24x16 to 60x40
    {"image-scale", "ScaleNearest", {2280, 1141, 1141, 1017, 1041, 1011, 1219}},
    {"image-scale", "ScaleBilinear4", {8511, 3788, 3885, 3859, 3899, 3678, 4375}},
    {"image-scale", "ScaleBilinear8", {9011, 3788, 3885, 3859, 3899, 3778, 4375}},
    // line: short, up to 16 pixels
    {"line", "SplitErrorLine", {163272, 46178, 45978, 46861, 100592, 53150, 44286}},
    {"line", "ExactLine", {35136, 24908, 25108, 24709, 24931, 26059, 25064}},
    {"line", "SubPixelLine", {72817, 33347, 33147, 32434, 34045, 35594, 33855}},
    {"line", "RoundedLine", {132308, 51480, 51280, 51214, 79755, 55030, 48123}},
    {"line", "DistanceLine", {218130, 57545, 56639, 55262, 64167, 62242, 54891}},
    // line-clip: ends around the screen
    {"line-clip", "Parameters16", {149149, 23637, 23448, 23353, 73305, 30066, 13798}},
    {"line-clip", "Parameters32", {228241, 29530, 29530, 29541, 129120, 41346, 13966}},
    {"line-clip", "LiangBarsky", {654721, 93850, 94273, 95057, 315485, 126797, 54960}},
    {"line-clip", "CohenSutherland", {631609, 92964, 92647, 93588, 311480, 132144, 61102}},
    {"line-clip", "Skala", {665750, 96234, 95860, 97065, 315466, 134640, 62795}},
    // nearest-colour: 16 greys
    {"nearest-colour", "NearestRgb", {45406, 30001, 30001, 33502, 36802, 27021, 33316}},
    {"nearest-colour", "NearestWeighted", {51703, 34801, 34801, 38302, 40002, 33420, 36513}},
    {"nearest-colour", "NearestLuv", {239438, 55504, 55604, 58305, 75993, 56123, 59192}},
    {"nearest-colour", "NearestLab", {546664, 90266, 90266, 93466, 87683, 92245, 91855}},
    // normalise: any vector
    {"normalise", "UnitTable", {30546, 11306, 11306, 11307, 10806, 16171, 13252}},
    {"normalise", "UnitNewton", {31746, 12005, 11906, 12006, 11406, 16871, 14452}},
    {"normalise", "UnitNewtonExact", {68951, 15708, 15708, 15709, 15808, 20476, 16657}},
    {"normalise", "UnitRootDivision", {70259, 23387, 23387, 21893, 52993, 25205, 24237}},
    // polygon-clip: 6 vertices
    {"polygon-clip", "SutherlandHodgman", {2717500, 717150, 721038, 765850, 1119838, 917600, 628338}},
    {"polygon-clip", "GreinerHormann", {7132812, 1523550, 1525525, 1611525, 1731875, 1545475, 1862400}},
    {"polygon-clip", "CutAndClassify", {43594662, 8726075, 8850950, 8679350, 9702338, 10116738, 9132325}},
    // polygon-fill: triangles to pentagons
    {"polygon-fill", "ScanlineFill", {1148119, 823494, 817150, 824625, 876869, 957725, 1011312}},
    {"polygon-fill", "CriticalPointsFill", {1430556, 1093194, 1095931, 1086456, 1068438, 1111719, 1146100}},
    {"polygon-fill", "BasicFill", {5899175, 2428912, 2496425, 2451625, 3270488, 2768538, 2733506}},
    // ramp: 16 greys, black to white
    {"ramp", "MixCodes", {8138, 1301, 1301, 1301, 9520, 1201, 1901}},
    {"ramp", "MixSquares", {26214, 8564, 8563, 8045, 20101, 8661, 9205}},
    {"ramp", "MixTable16", {28570, 10701, 10701, 10701, 23358, 13180, 12604}},
    {"ramp", "MixTable32", {112057, 15215, 15215, 15115, 65940, 20147, 12093}},
    // reciprocal: any divisor
    {"reciprocal", "ReciprocalTable256", {4992, 1101, 1101, 1101, 1301, 2809, 1601}},
    {"reciprocal", "ReciprocalTable256Newton", {6291, 1501, 1501, 1501, 1701, 3310, 2302}},
    {"reciprocal", "ReciprocalTable256NewtonExact", {7993, 2501, 2501, 2501, 2601, 4411, 4004}},
    {"reciprocal", "ReciprocalDivision", {11755, 100, 100, 100, 12978, 201, 401}},
    // reciprocal-root: any number of bits
    {"reciprocal-root", "ReciprocalRootTable", {4886, 1101, 1101, 1101, 1101, 2956, 1802}},
    {"reciprocal-root", "ReciprocalRootNewton", {6086, 1701, 1701, 1701, 1701, 3656, 2904}},
    {"reciprocal-root", "ReciprocalRootNewton2", {12494, 2702, 2702, 2702, 2702, 4558, 4005}},
    {"reciprocal-root", "ReciprocalRootNewtonExact", {40921, 5600, 5600, 5600, 5666, 7959, 5501}},
    {"reciprocal-root", "ReciprocalRootDivision", {153059, 46140, 46140, 46140, 91253, 68309, 17966}},
    // sine: any angle
    {"sine", "SineTable256Nearest", {1411, 1001, 1001, 1001, 901, 1314, 1401}},
    {"sine", "SineParabola", {1712, 1100, 1100, 1100, 901, 1214, 1601}},
    {"sine", "SineParabolaCorrected", {3312, 1701, 1701, 1701, 1501, 2014, 2602}},
    {"sine", "SineBhaskara", {11910, 1400, 1400, 1400, 11394, 1614, 2304}},
    {"sine", "SineTable64Linear", {2614, 1601, 1601, 1601, 1501, 2214, 2302}},
    {"sine", "SinePolynomial5", {3314, 1802, 1802, 1802, 1902, 2115, 2704}},
    {"sine", "SineTable256Linear", {2831, 1518, 1701, 1601, 1901, 2514, 2262}},
    {"sine", "SinePolynomial7", {4214, 2102, 2102, 2102, 2102, 2518, 3205}},
    {"sine", "SineCordic", {36513, 21300, 21300, 21300, 24601, 19717, 25205}},
    // square-root: any number of bits
    {"square-root", "RootTable", {4045, 1090, 1095, 1091, 1101, 2826, 1586}},
    {"square-root", "RootReciprocalNewton", {6615, 2079, 2086, 2080, 2187, 3913, 3070}},
    {"square-root", "RootTableDivision", {11450, 1980, 1986, 1981, 9201, 3617, 2970}},
    {"square-root", "RootReciprocalNewtonExact", {7879, 2964, 2964, 2964, 3162, 4797, 4505}},
    {"square-root", "RootNewtonDivision", {25124, 2433, 2433, 2433, 21850, 3862, 3640}},
    {"square-root", "RootBitwise", {8978, 7241, 7241, 6514, 6535, 7345, 7011}},
    // triangle: sides up to 60 pixels
    {"triangle", "WalkSnapped0", {341412, 247175, 247175, 245250, 258988, 278850, 320388}},
    {"triangle", "WalkSnapped4", {395125, 257912, 257912, 255988, 274112, 293275, 331438}},
    {"triangle", "WalkExact", {388850, 253238, 253238, 251288, 269775, 288512, 327562}},
    {"triangle", "Blocks", {4610275, 2873350, 2873350, 2876125, 3097912, 2873138, 2560975}},
    {"triangle", "Box32Snapped4", {4443312, 2765350, 2765350, 2760075, 3023638, 2707412, 2394688}},
    {"triangle", "Box32", {4548962, 2785788, 2785988, 2780750, 3047762, 2728425, 2410875}},
    {"triangle", "Box64", {17753188, 3610212, 3610412, 3352550, 4131200, 4431662, 2422175}},
}};
// clang-format on

}  // namespace intaglio::number
