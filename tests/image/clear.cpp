// SPDX-License-Identifier: MIT
#include <intaglio/image/clear.hpp>
#include <tests/image/formats.hpp>

namespace {

using intaglio::Argument;
using intaglio::Error;
using intaglio::Status;
using intaglio::image::Surface;
using oracle::Packed;

template <class F>
class Clear : public testing::Test {};
TYPED_TEST_SUITE(Clear, tests::AllFormats);

TYPED_TEST(Clear, EverySubSurfaceIsFilledAndNoOtherBitChanges) {
  oracle::Random random(21);
  for (int x = 0; x < 21; ++x)
    for (int width = 1; x + width <= 21; ++width) {
      Packed memory = tests::packed_rows<TypeParam>(21, 5, 2);
      memory.randomize(random);
      Packed expected = memory;
      const auto index = static_cast<unsigned>(random.bits()) & TypeParam::max_index;
      for (int row = 1; row < 4; ++row)
        for (int column = x; column < x + width; ++column) expected.set(column, row, index);
      const auto surface = tests::surface_over<TypeParam>(memory, 21, 5).sub({x, 1, width, 3});
      ASSERT_TRUE(clear(surface, index).ok());
      ASSERT_EQ(memory.bytes(), expected.bytes()) << x << ' ' << width << ' ' << index;
    }
}

TYPED_TEST(Clear, AnIndexThatTheFormatCannotHoldIsNamed) {
  Packed memory = tests::packed_rows<TypeParam>(21, 5);
  const Packed expected = memory;
  const auto surface = tests::surface_over<TypeParam>(memory, 21, 5);
  const Status status{Error::out_of_range, Argument::index, TypeParam::max_index};
  EXPECT_EQ(clear(surface, TypeParam::max_index + 1U), status);
  EXPECT_EQ(clear(surface, 0xFFFFFFFFU), status);
  EXPECT_EQ(memory.bytes(), expected.bytes());
}

TYPED_TEST(Clear, AnEmptySurfaceIsNoError) { EXPECT_TRUE(clear(Surface<TypeParam>{}, 0).ok()); }

}  // namespace
