// SPDX-License-Identifier: MIT
//
// Choices over a table that is made up; over the library's own see tests/lab/cheapest, also for what mustn't
// compile.
#include <intaglio/number/cheapest.hpp>

#include <gtest/gtest.h>

#include <array>
#include <concepts>

namespace {

using intaglio::number::Bound;
using intaglio::number::cheapest;
using intaglio::number::Core;
using intaglio::number::exactly;
using intaglio::number::Family;
using intaglio::number::lsb_q15;
using intaglio::number::lsb_q16;
using intaglio::number::MeasuredCost;
using intaglio::number::parts_of_value;

struct Coarse {
  static constexpr Bound bound = lsb_q15(4000);
};
struct Middle {
  static constexpr Bound bound = lsb_q15(1000);
};
struct AlsoMiddle {
  static constexpr Bound bound = lsb_q15(1000);
};
struct Fine {
  static constexpr Bound bound = lsb_q15(501);
};
struct Exact {
  static constexpr Bound bound = exactly();
};
struct InOtherUnits {
  static constexpr Bound bound = lsb_q16(1);
};
template <int Size>
struct Sized {
  static constexpr Bound bound = lsb_q15(8000 / Size);
};

// Cortex-M0+ has no divider: Fine is dear there.
constexpr std::array<MeasuredCost, 13> costs{{
    {"precision", "Coarse", {1000, 1000, 1000, 1000, 1000, 1000, 1000}},
    {"precision", "Middle", {2000, 2000, 1500, 2000, 2000, 2000, 2000}},
    {"precision", "AlsoMiddle", {2000, 2001, 1501, 2000, 2000, 2000, 2000}},
    {"precision", "Fine", {9000, 1999, 1500, 3000, 3000, 3000, 500}},
    {"precision", "Exact", {20000, 20000, 20000, 20000, 20000, 20000, 20000}},
    {"precision", "InOtherUnits", {1, 1, 1, 1, 1, 1, 1}},
    {"pair", "Coarse", {7, 7, 7, 7, 7, 7, 7}},
    {"pair", "Fine", {6, 6, 6, 6, 6, 6, 6}},
    {"triple", "Coarse", {1, 1, 1, 1, 1, 1, 1}},
    {"triple", "Fine", {2, 2, 2, 2, 2, 2, 2}},
    {"triple", "Sized<2>", {3, 3, 3, 3, 3, 3, 3}},
    {"sizes", "Sized<2>", {200, 200, 200, 200, 200, 200, 200}},
    {"sizes", "Sized<16>", {300, 300, 300, 300, 300, 300, 300}},
}};

using All = Family<Coarse, AlsoMiddle, Middle, Fine, Exact>;

template <Core core, Bound bound, class F = All>
using Chosen = cheapest<F, core, bound, costs>;

TEST(Cheapest, IsTheCheapestThatMeetsTheBoundOnThatCore) {
  EXPECT_TRUE((std::same_as<Chosen<Core::cortex_m0plus, lsb_q15(4000)>, Coarse>));
  EXPECT_TRUE((std::same_as<Chosen<Core::cortex_m0plus, lsb_q15(3999)>, AlsoMiddle>));
  EXPECT_TRUE((std::same_as<Chosen<Core::cortex_m3, lsb_q15(3999)>, Fine>));
  EXPECT_TRUE((std::same_as<Chosen<Core::cortex_m7, lsb_q15(3999)>, AlsoMiddle>));
  EXPECT_TRUE((std::same_as<Chosen<Core::cortex_m0plus, lsb_q15(501)>, Fine>));
  EXPECT_TRUE((std::same_as<Chosen<Core::cortex_m0plus, lsb_q15(500)>, Exact>));
}

TEST(Cheapest, IsTheMoreAccurateAmongEquallyCheapOnes) {
  EXPECT_TRUE((std::same_as<Chosen<Core::cortex_m4, lsb_q15(1000)>, Fine>));
}

TEST(Cheapest, IsTheLastCoresOwnFigure) {
  EXPECT_TRUE((std::same_as<Chosen<Core::x86_64, lsb_q15(4000)>, Fine>));
}

TEST(Cheapest, TakesABoundOfZeroInAnyUnit) {
  EXPECT_TRUE((std::same_as<Chosen<Core::cortex_m3, exactly()>, Exact>));
  EXPECT_TRUE((std::same_as<Chosen<Core::cortex_m3, lsb_q15(0)>, Exact>));
  EXPECT_TRUE((std::same_as<Chosen<Core::cortex_m3, parts_of_value(0)>, Exact>));
}

TEST(Cheapest, LeavesOutWhatIsInAnotherUnitThanTheFamily) {
  using Mixed = Family<Exact, Coarse, InOtherUnits>;
  EXPECT_TRUE((std::same_as<Chosen<Core::cortex_m3, lsb_q15(5000), Mixed>, Coarse>));
}

TEST(Cheapest, TakesTheFiguresOfTheSmallestFamilyThatHasAllRungs) {
  using Pair = Family<Fine, Coarse>;
  EXPECT_TRUE((std::same_as<Chosen<Core::cortex_m3, lsb_q15(4000), Pair>, Fine>));
  using Triple = Family<Fine, Coarse, Sized<2>>;
  EXPECT_TRUE((std::same_as<Chosen<Core::cortex_m3, lsb_q15(4000), Triple>, Coarse>));
}

TEST(Cheapest, KnowsRungsThatAreTemplates) {
  using Sizes = Family<Sized<2>, Sized<16>>;
  EXPECT_TRUE((std::same_as<Chosen<Core::arm926, lsb_q15(4000), Sizes>, Sized<2>>));
  EXPECT_TRUE((std::same_as<Chosen<Core::arm926, lsb_q15(3999), Sizes>, Sized<16>>));
}

TEST(TypeName, HasNoNamespaces) {
  using intaglio::number::type_name;
  EXPECT_EQ(type_name<Coarse>(), "Coarse");
  EXPECT_EQ(type_name<Sized<16>>(), "Sized<16>");
  EXPECT_EQ(type_name<intaglio::number::Core>(), "Core");
  EXPECT_EQ(type_name<int>(), "int");
}

}  // namespace
