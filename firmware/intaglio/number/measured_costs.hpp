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
inline constexpr std::array<MeasuredCost, 118> measured_costs{{
    // antialiasing: triangles, where one edge is in a pixel
    {"antialiasing", "NoAntialiasing", {359900, 210900, 209667, 208633, 223733, 239100, 250533}},
    {"antialiasing", "ExactArea", {1873500, 667133, 665700, 666100, 952700, 787567, 777200}},
    {"antialiasing", "Samples2x2", {5108933, 2418600, 2413500, 2465767, 3244500, 2570933, 3129167}},
    {"antialiasing", "Samples3x3", {6435300, 3019533, 3015600, 3096133, 5357733, 3260400, 3973533}},
    {"antialiasing", "Bartlett3x3", {6437867, 3022600, 3019167, 3099467, 5349767, 3264033, 3976267}},
    {"antialiasing", "Samples4x4", {7636900, 3544867, 3543500, 3650400, 5232033, 3871167, 4727100}},
    {"antialiasing", "Masks4x4", {11540533, 5734900, 5747467, 5666000, 6260900, 6154967, 6275867}},
    {"antialiasing", "Samples15x17", {11023367, 3552033, 3540867, 3659800, 3784067, 2892867, 4037767}},
    {"antialiasing", "PittewayWatkinson", {22863367, 4349600, 4337700, 4315933, 5291600, 4880733, 4659467}},
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
    {"circle", "MidpointCircle32", {379606, 226616, 227406, 225997, 229959, 232384, 254903}},
    {"circle", "MidpointCircle16", {384444, 230644, 231822, 232797, 241919, 242722, 257175}},
    {"circle", "MidpointCircle64", {398069, 234641, 236169, 236272, 240197, 246566, 255103}},
    {"circle", "SineCircle", {604572, 340553, 342469, 342972, 376947, 359703, 392959}},
    // convex-fill: octagons up to 20 pixels
    {"convex-fill", "ScanlineFill", {467650, 301450, 298325, 300625, 326712, 336750, 342338}},
    {"convex-fill", "CriticalPointsFill", {525412, 358325, 360950, 360125, 375088, 390888, 361400}},
    {"convex-fill", "EdgeFunctionFill", {1898550, 644162, 645538, 693412, 713200, 577275, 708275}},
    {"convex-fill", "BasicFill", {1178125, 631025, 658875, 644525, 694650, 681062, 685038}},
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
    {"ellipse", "MidpointEllipse32", {386050, 231056, 233341, 235822, 241556, 233919, 263294}},
    {"ellipse", "MidpointEllipse16", {397081, 246362, 247797, 254466, 269094, 259994, 266347}},
    {"ellipse", "RowEllipse", {882350, 484122, 486959, 508891, 500547, 522544, 431988}},
    {"ellipse", "MidpointEllipse64", {435588, 257769, 259103, 258853, 261950, 276416, 264581}},
    {"ellipse", "SineEllipse", {554019, 317338, 318778, 318884, 357281, 345203, 368659}},
    // flood-fill: empty chambers
    {"flood-fill", "SpanFlood", {21522050, 9947200, 9988200, 9976000, 9008200, 8455750, 8621650}},
    {"flood-fill", "PixelStackFlood", {97696850, 37422400, 37888350, 38362450, 50473500, 29531350, 44270400}},
    {"flood-fill", "SweepFlood", {172745050, 47835300, 47835400, 41616200, 176783900, 33505450, 46910300}},
    // image-rotate: 40x30 by any angle
    {"image-rotate", "RotateNearest", {31777, 5147, 5151, 5107, 13530, 6967, 5095}},
    {"image-rotate", "RotateThreeShear", {38555, 7867, 7851, 7914, 20029, 10694, 7044}},
    {"image-rotate", "RotateBilinear", {40913, 9061, 9204, 9124, 17450, 11659, 9412}},
    // image-scale: 24x16 to 60x40
    {"image-scale", "ScaleNearest", {1472, 1050, 1052, 1129, 1152, 914, 1330}},
    {"image-scale", "ScaleBilinear4", {8655, 4110, 4208, 3980, 3820, 3573, 4092}},
    {"image-scale", "ScaleBilinear8", {9155, 4110, 4208, 3980, 3820, 3575, 4092}},
    {"image-scale", "ScaleBox", {12575, 5872, 5914, 5768, 6192, 4327, 6089}},
    // line: short, up to 16 pixels
    {"line", "SplitErrorLine", {163272, 46178, 45978, 46861, 100592, 53150, 44286}},
    {"line", "ExactLine", {35136, 24908, 25108, 24709, 24931, 26059, 25064}},
    {"line", "SubPixelLine", {72817, 33347, 33147, 32434, 34045, 35594, 33855}},
    {"line", "RoundedLine", {132308, 51480, 51280, 51214, 79755, 55030, 48123}},
    {"line", "DistanceLine", {218130, 57545, 56639, 55262, 64167, 62242, 54891}},
    // line-clip: ends around the screen
    {"line-clip", "Parameters16", {159509, 26732, 26638, 26417, 76790, 32168, 15084}},
    {"line-clip", "Parameters32", {238601, 32295, 32200, 32200, 132262, 43258, 15108}},
    {"line-clip", "LiangBarsky", {661826, 95384, 95919, 96703, 317231, 128870, 56471}},
    {"line-clip", "CohenSutherland", {638714, 94498, 94293, 95234, 313227, 134217, 62612}},
    {"line-clip", "Skala", {672855, 97768, 97506, 98711, 317212, 136713, 64306}},
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
    {"polygon-clip", "SutherlandHodgman", {2718612, 717250, 721238, 766050, 1119938, 917638, 628338}},
    {"polygon-clip", "GreinerHormann", {7132788, 1523738, 1525625, 1611525, 1731875, 1545475, 1862312}},
    {"polygon-clip", "CutAndClassify", {43594638, 8726262, 8851050, 8679350, 9702338, 10116738, 9132238}},
    // polygon-fill: triangles to pentagons
    {"polygon-fill", "ScanlineFill", {1149394, 824662, 813206, 820681, 877944, 958250, 1011688}},
    {"polygon-fill", "CriticalPointsFill", {1431525, 1131394, 1134131, 1129988, 1117281, 1111419, 1130281}},
    {"polygon-fill", "BasicFill", {5899375, 2466700, 2534312, 2489638, 3318594, 2772019, 2747706}},
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
    {"triangle", "WalkSnapped0", {349912, 249188, 249188, 247262, 260712, 280225, 323712}},
    {"triangle", "WalkSnapped4", {399750, 256925, 256925, 255000, 273038, 291512, 332012}},
    {"triangle", "WalkExact", {389438, 253238, 253238, 251288, 269775, 288512, 327562}},
    {"triangle", "Blocks", {4610962, 2873350, 2873350, 2876125, 3097912, 2873138, 2560975}},
    {"triangle", "Box32Snapped4", {4452312, 2769575, 2769575, 2766325, 3028838, 2708812, 2399162}},
    {"triangle", "Box32", {4551050, 2787475, 2787675, 2782438, 3049712, 2729875, 2411275}},
    {"triangle", "Box64", {17755075, 3612238, 3612438, 3354575, 4133350, 4433000, 2422562}},
}};
// clang-format on

}  // namespace intaglio::number
