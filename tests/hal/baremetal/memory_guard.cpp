// SPDX-License-Identifier: MIT
#include <hal/baremetal/memory_guard.hpp>
#include <tests/hal/baremetal/fake_core.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cstdint>

namespace {

using hal::baremetal::MemoryGuard;

/// A protection unit with the fault registers before it.
class Unit : public testing::Test {
 protected:
  static constexpr std::size_t status = 0;
  static constexpr std::size_t address = 3;
  static constexpr std::size_t type = 0x68 / 4;
  static constexpr std::size_t control = type + 1;
  static constexpr std::size_t number = type + 2;
  static constexpr std::size_t base = type + 3;
  static constexpr std::size_t attributes = type + 4;

  std::uintptr_t at() { return reinterpret_cast<std::uintptr_t>(&registers_[type]); }
  std::uint32_t access() const { return registers_[attributes] >> 24U & 7U; }

  std::array<std::uint32_t, type + 5> registers_{};
};

TEST_F(Unit, IsOnWithTheDefaultMapBehindAndOpensAndCloses) {
  registers_[type] = 8U << 8U;
  const MemoryGuard guard(0x2000'1000, 4096, at());
  ASSERT_TRUE(guard.start());
  EXPECT_EQ(registers_[control], 5U);
  EXPECT_EQ(registers_[base], 0x2000'1000U);
  EXPECT_EQ(registers_[attributes] & 1U, 1U);
  EXPECT_EQ(2U << (registers_[attributes] >> 1U & 31U), 4096U);
  EXPECT_EQ(access(), 3U);
  guard.close();
  EXPECT_EQ(access(), 6U);
  guard.open();
  EXPECT_EQ(access(), 3U);
}

TEST_F(Unit, ChangesItsOwnRegionAndIsInForceAtOnce) {
  registers_[type] = 8U << 8U;
  registers_[number] = 5;  // Of whoever else uses the unit.
  const MemoryGuard guard(0x2000'1020, 32, at());
  const int before = fake_core::synchronised();
  ASSERT_TRUE(guard.start()) << "the least piece";
  EXPECT_EQ(registers_[number], 0U);
  EXPECT_GT(fake_core::synchronised(), before);
  for (const bool closed : {true, false}) {
    registers_[number] = 5;
    const int changed = fake_core::synchronised();
    if (closed) {
      guard.close();
    } else {
      guard.open();
    }
    EXPECT_EQ(registers_[number], 0U);
    EXPECT_EQ(fake_core::synchronised(), changed + 1);
    EXPECT_EQ(access(), closed ? 6U : 3U);
  }
}

TEST_F(Unit, ThatIsntThereOrCantGuardThePieceDoesntStart) {
  EXPECT_FALSE(MemoryGuard(0x2000'1000, 4096, at()).start());
  registers_[type] = 8U << 8U;
  EXPECT_FALSE(MemoryGuard(0x2000'1004, 4096, at()).start());
  EXPECT_FALSE(MemoryGuard(0x2000'0000, 4000, at()).start());
  EXPECT_FALSE(MemoryGuard(0x2000'0000, 16, at()).start());
  EXPECT_EQ(registers_[control], 0U);
}

TEST_F(Unit, SaysWhetherAFaultWasAWriteToThePiece) {
  const MemoryGuard guard(0x2000'1000, 4096, at());
  const auto caught = [&](std::uint32_t what, std::uint32_t where) {
    registers_[status] = what;
    registers_[address] = where;
    return guard.caught();
  };
  EXPECT_TRUE(caught(0x82, 0x2000'1000));
  EXPECT_TRUE(caught(0x82, 0x2000'1FFF));
  EXPECT_FALSE(caught(0x82, 0x2000'2000));
  EXPECT_FALSE(caught(0x82, 0x2000'0FFF));
  EXPECT_FALSE(caught(0x02, 0x2000'1000)) << "the address isn't valid";
  EXPECT_FALSE(caught(0x80, 0x2000'1000)) << "not a data access";
}

}  // namespace
