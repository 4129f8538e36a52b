// SPDX-License-Identifier: MIT
#include <hal/baremetal/pl011.hpp>
#include <hal/baremetal/pl022.hpp>
#include <hal/baremetal/pl061.hpp>
#include <hal/baremetal/pl190.hpp>
#include <hal/baremetal/systick.hpp>
#include <tests/hal/baremetal/fake_core.hpp>

#include <gtest/gtest.h>

#include <array>
#include <csignal>
#include <cstdint>
#include <limits>
#include <string>
#include <sys/time.h>

namespace {

using namespace hal::baremetal;

class Text final : public TextOutput {
 public:
  std::string said;

 private:
  void do_put(char c) noexcept override { said += c; }
};

template <std::size_t Words>
std::uintptr_t address(std::array<std::uint32_t, Words>& registers) {
  return reinterpret_cast<std::uintptr_t>(registers.data());
}

TEST(TextOutput, WritesNumbersInBothBases) {
  Text out;
  out.decimal(0);
  out.text(" ");
  out.decimal(std::numeric_limits<std::uint32_t>::max());
  out.text(" ");
  out.hex(0x0123'ABCDU);
  out.text(" ");
  out.decimal(1000);
  EXPECT_EQ(out.said, "0 4294967295 0123abcd 1000");
}

TEST(Pl011, PutsBytesIntoItsDataRegister) {
  std::array<std::uint32_t, 16> registers{};
  Pl011 uart(address(registers));
  uart.start();
  EXPECT_EQ(registers[0x30 / 4], 0x301U);
  uart.text("ab\xFF");
  EXPECT_EQ(registers[0], 0xFFU) << "a character above 127 is one byte, not a negative number";
}

TEST(Pl061Pin, ChangesItsLineAlone) {
  std::array<std::uint32_t, 512> registers{};
  Pl061Pin pin(address(registers), 7);
  pin.start();
  EXPECT_EQ(registers[0x400 / 4], 0x80U);
  ASSERT_TRUE(pin.set(true).ok());
  EXPECT_EQ(registers[4U << 7U >> 2U], 0x80U) << "the address masks the other lines";
  ASSERT_TRUE(pin.set(false).ok());
  EXPECT_EQ(registers[4U << 7U >> 2U], 0U);
}

TEST(Pl061Pin, KeepsTheDirectionOfOtherLines) {
  std::array<std::uint32_t, 512> registers{};
  registers[0x400 / 4] = 0x11;
  Pl061Pin(address(registers), 2).start();
  EXPECT_EQ(registers[0x400 / 4], 0x15U);
}

TEST(Pl022, SendsInModeThreeWithEightBits) {
  std::array<std::uint32_t, 8> registers{};
  registers[3] = 2;  // room to transmit, nothing received, not busy
  Pl022 bus(address(registers));
  bus.start();
  EXPECT_EQ(registers[0] & 0xFU, 7U);
  EXPECT_EQ(registers[0] >> 6U & 3U, 3U);
  EXPECT_EQ(registers[1], 2U);
  const std::array<std::uint8_t, 3> bytes{1, 2, 0xFE};
  ASSERT_TRUE(bus.write(bytes).ok());
  EXPECT_EQ(registers[2], 0xFEU);
}

TEST(Pl190, EnablesOneSource) {
  std::array<std::uint32_t, 8> registers{};
  Pl190(address(registers)).enable(16);
  EXPECT_EQ(registers[0x10 / 4], 1U << 16U);
}

TEST(SysTick, CountsTicksAndSleepsUntilATime) {
  SysTick clock(12'500'000, 12'500);
  EXPECT_EQ(clock.now(), 0U);
  clock.on_interrupt();
  EXPECT_EQ(clock.now(), 1'000'000U);
  fake_core::on_sleep = [&] { clock.on_interrupt(); };
  clock.wait_until(3'000'001);
  fake_core::on_sleep = nullptr;
  EXPECT_EQ(clock.now(), 4'000'000U) << "at or after the time, never before";
  clock.wait_until(4'000'000);
}

TEST(SysTick, StartsFromTheReloadValueWithItsInterruptOn) {
  std::array<std::uint32_t, 3> registers{0, 0, 99};
  SysTick clock(12'500'000, 12'500, address(registers));
  clock.start();
  EXPECT_EQ(registers, (std::array<std::uint32_t, 3>{7, 12'499, 0}));
}

TEST(SysTick, TellsTheCycleAndNeverGoesBack) {
  std::array<std::uint32_t, 3> registers{};
  std::uint32_t& left = registers[2];
  SysTick clock(1'000'000, 1'000, address(registers));
  std::uint32_t expected = 0;
  for (int tick = 0; tick < 3; ++tick) {
    // It is at 0 in the cycle in which a tick is due.
    for (left = 999; left > 0; --left) ASSERT_EQ(clock.cycles(), ++expected);
    ++expected;
    clock.on_interrupt();
  }
}

TEST(SysTick, CyclesWrapAt32Bits) {
  std::array<std::uint32_t, 3> registers{0, 0, 1};
  SysTick clock(1'000'000'000, 1U << 24U, address(registers));
  for (int tick = 0; tick < 255; ++tick) clock.on_interrupt();
  EXPECT_EQ(clock.cycles(), 0xFFFF'FFFFU);
  clock.on_interrupt();
  registers[2] = (1U << 24U) - 1U;
  EXPECT_EQ(clock.cycles(), 1U);
}

/// Interrupted where it stands, as a processor is.
std::array<volatile std::uint32_t, 3> interrupted_registers{};
SysTick* interrupted = nullptr;
void take_tick(int) {
  interrupted->on_interrupt();
  interrupted_registers[2] = 999;
}

TEST(SysTick, ATickThatIsDueIsWaitedFor) {
  SysTick clock(1'000'000, 1'000, reinterpret_cast<std::uintptr_t>(interrupted_registers.data()));
  interrupted = &clock;
  interrupted_registers[2] = 0;
  const auto before = std::signal(SIGALRM, take_tick);
  const itimerval soon{{0, 0}, {0, 1'000}};
  ASSERT_EQ(setitimer(ITIMER_REAL, &soon, nullptr), 0);
  EXPECT_EQ(clock.cycles(), 1'001U);
  std::signal(SIGALRM, before);
}

}  // namespace
