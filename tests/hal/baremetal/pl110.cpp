// SPDX-License-Identifier: MIT
#include <hal/baremetal/pl110.hpp>
#include <tests/hal/baremetal/fake_core.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace {

using hal::baremetal::Pl110;

constexpr std::size_t upper_base = 0x10 / 4;
constexpr std::size_t control = 0x18 / 4;
constexpr std::size_t interrupt_mask = 0x1C / 4;
constexpr std::size_t interrupt_status = 0x24 / 4;
constexpr std::size_t interrupt_clear = 0x28 / 4;
constexpr std::size_t palette = 0x200 / 4;
constexpr std::uint32_t next_base = 4;
constexpr std::uint32_t enabled = 1;

class Lcd : public testing::Test {
 public:
  using Registers = std::array<std::uint32_t, 0x400 / 4>;

  ~Lcd() override { fake_core::on_sleep = nullptr; }

  std::uintptr_t registers_address() { return reinterpret_cast<std::uintptr_t>(registers.data()); }
  std::uint32_t address_of(int buffer) {
    return static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(panel.buffer(buffer).data()));
  }
  void vblank() {
    registers[interrupt_status] = next_base;
    panel.on_interrupt();
    registers[interrupt_status] = 0;
  }

  static constexpr Pl110::Geometry geometry{32, 4, 8};
  Registers registers{};
  std::vector<std::uint8_t> memory = std::vector<std::uint8_t>(Pl110::memory_bytes(geometry));
  Pl110 panel{registers_address(), geometry, memory};
};

TEST_F(Lcd, StartsWithBufferZeroOnDisplayAndItsInterruptOn) {
  ASSERT_TRUE(panel.start().ok());
  EXPECT_EQ(registers[upper_base], address_of(0));
  EXPECT_EQ(registers[interrupt_mask], next_base);
  EXPECT_EQ(registers[control] & enabled, enabled);
  EXPECT_EQ(registers[control] >> 1U & 7U, 3U) << "8 bits a pixel";
  EXPECT_EQ((registers[0] >> 2U & 63U) + 1U, 32U / 16U) << "pixels a line / 16";
  EXPECT_EQ((registers[1] & 1023U) + 1U, 4U) << "lines";
  EXPECT_EQ((registers[2] >> 16U & 1023U) + 1U, 32U) << "clocks a line";
}

TEST_F(Lcd, TheTwoBuffersAreNeighboursAndThereIsNoThird) {
  EXPECT_EQ(panel.buffer(0).size(), 128U);
  EXPECT_EQ(panel.buffer(1).data(), memory.data() + 128);
  EXPECT_TRUE(panel.buffer(2).empty());
  EXPECT_TRUE(panel.buffer(-1).empty());
}

TEST_F(Lcd, ShowTouchesNoRegister) {
  ASSERT_TRUE(panel.start().ok());
  const Registers before = registers;
  const std::array<std::uint8_t, 6> colours{1, 2, 3, 4, 5, 6};
  ASSERT_TRUE(panel.show(1, colours).ok());
  EXPECT_EQ(registers, before);
  EXPECT_TRUE(panel.show_pending());
}

TEST_F(Lcd, BaseAndPaletteChangeTogetherInTheInterrupt) {
  ASSERT_TRUE(panel.start().ok());
  const std::array<std::uint8_t, 12> colours{255, 0, 0, 0, 255, 0, 0, 0, 255, 8, 16, 24};
  ASSERT_TRUE(panel.show(1, colours).ok());
  vblank();
  EXPECT_EQ(registers[upper_base], address_of(1));
  EXPECT_EQ(registers[palette], 0x001FU | 0x03E0U << 16U);
  EXPECT_EQ(registers[palette + 1], 0x7C00U | (1U | 2U << 5U | 3U << 10U) << 16U);
  EXPECT_EQ(registers[interrupt_clear], next_base);
  EXPECT_FALSE(panel.show_pending());
  EXPECT_EQ(panel.vblank_count(), 1U);
}

TEST_F(Lcd, AnOddNumberOfColoursLeavesTheNextEntryAlone) {
  ASSERT_TRUE(panel.start().ok());
  registers[palette] = 0x1234'5678U;
  registers[palette + 1] = 0xABCD'0000U;
  const std::array<std::uint8_t, 3> one{255, 255, 255};
  ASSERT_TRUE(panel.show(0, one).ok());
  vblank();
  EXPECT_EQ(registers[palette], 0x1234'7FFFU);
  EXPECT_EQ(registers[palette + 1], 0xABCD'0000U);
}

TEST_F(Lcd, ShowWithoutColoursKeepsThePalette) {
  ASSERT_TRUE(panel.start().ok());
  registers[palette] = 0x1234'5678U;
  ASSERT_TRUE(panel.show(1, {}).ok());
  vblank();
  EXPECT_EQ(registers[palette], 0x1234'5678U);
  EXPECT_EQ(registers[upper_base], address_of(1));
}

TEST_F(Lcd, AVblankWithoutRequestChangesNothing) {
  ASSERT_TRUE(panel.start().ok());
  registers[upper_base] = 77;
  vblank();
  EXPECT_EQ(registers[upper_base], 77U);
  EXPECT_EQ(panel.vblank_count(), 1U);
}

TEST_F(Lcd, AnInterruptOfAnotherSourceIsNoVblank) {
  ASSERT_TRUE(panel.start().ok());
  ASSERT_TRUE(panel.show(1, {}).ok());
  registers[interrupt_status] = 8;
  panel.on_interrupt();
  EXPECT_EQ(panel.vblank_count(), 0U);
  EXPECT_TRUE(panel.show_pending());
}

TEST_F(Lcd, ALaterRequestReplacesTheOneBefore) {
  ASSERT_TRUE(panel.start().ok());
  ASSERT_TRUE(panel.show(1, {}).ok());
  ASSERT_TRUE(panel.show(0, {}).ok());
  registers[upper_base] = 0;
  vblank();
  EXPECT_EQ(registers[upper_base], address_of(0));
}

TEST_F(Lcd, ColoursOfARequestThatIsReplacedStayUnlessTheLaterOneBringsThem) {
  ASSERT_TRUE(panel.start().ok());
  const std::array<std::uint8_t, 6> two{255, 0, 0, 0, 255, 0};
  const std::array<std::uint8_t, 3> one{0, 0, 255};
  ASSERT_TRUE(panel.show(1, two).ok());
  ASSERT_TRUE(panel.show(1, {}).ok());
  ASSERT_TRUE(panel.show(1, one).ok());
  vblank();
  EXPECT_EQ(registers[palette], 0x7C00U | 0x03E0U << 16U);
  registers[palette] = 0;
  ASSERT_TRUE(panel.show(0, {}).ok());
  vblank();
  EXPECT_EQ(registers[palette], 0U) << "what has been shown isn't loaded again";
}

TEST_F(Lcd, APaletteAloneWaitsForVblankToo) {
  ASSERT_TRUE(panel.start().ok());
  const Registers before = registers;
  const std::array<std::uint8_t, 3> white{255, 255, 255};
  ASSERT_TRUE(panel.load_palette(white).ok());
  EXPECT_EQ(registers, before);
  EXPECT_EQ(panel.load_palette(white), hal::Status(hal::Error::busy, hal::Part::palette));
  vblank();
  EXPECT_EQ(registers[palette] & 0xFFFFU, 0x7FFFU);
  EXPECT_EQ(registers[upper_base], address_of(0));
}

TEST_F(Lcd, WaitingSleepsUntilTheNextVblank) {
  ASSERT_TRUE(panel.start().ok());
  int sleeps = 0;
  fake_core::on_sleep = [&] {
    EXPECT_TRUE(fake_core::masked()) << "an interrupt here would be slept through";
    if (++sleeps == 3) vblank();  // what woke the core before was something else
  };
  EXPECT_TRUE(panel.wait_for_vblank().ok());
  EXPECT_EQ(sleeps, 3);
  EXPECT_FALSE(fake_core::masked());
}

TEST_F(Lcd, BeforeStartNothingIsShownAndNothingWaitedFor) {
  EXPECT_EQ(panel.show(0, {}), hal::Status(hal::Error::unsupported, hal::Part::panel));
  EXPECT_EQ(panel.wait_for_vblank(), hal::Status(hal::Error::timeout, hal::Part::panel));
}

TEST_F(Lcd, IsNoWritePanel) {
  ASSERT_TRUE(panel.start().ok());
  const std::array<std::uint8_t, 128> pixels{};
  EXPECT_EQ(panel.write({0, 0, 32, 4}, pixels, 32).error(), hal::Error::unsupported);
}

TEST_F(Lcd, RefusesWhatItCannotScan) {
  for (const Pl110::Geometry& bad : {Pl110::Geometry{0, 4, 8},
                                     {24, 4, 8},
                                     {1040, 4, 8},
                                     {32, 0, 8},
                                     {32, 1025, 8},
                                     {32, 4, 3},
                                     {32, 4, 16},
                                     {-32, 4, 8},
                                     {32, -4, 8}}) {
    std::vector<std::uint8_t> plenty(std::size_t{1} << 22U);
    Pl110 other(registers_address(), bad, plenty);
    EXPECT_EQ(other.start(), hal::Status(hal::Error::invalid, hal::Part::panel))
        << bad.width << 'x' << bad.height << 'x' << bad.bits_per_pixel;
    EXPECT_EQ(registers, Registers{});
  }
}

TEST_F(Lcd, ScansTheLeastAndTheLargest) {
  std::vector<std::uint8_t> plenty(std::size_t{1} << 21U);
  for (const Pl110::Geometry& good : {Pl110::Geometry{16, 1, 8}, {1024, 1024, 8}})
    EXPECT_TRUE(Pl110(registers_address(), good, plenty).start().ok()) << good.width;
}

TEST_F(Lcd, RefusesTooLittleMemory) {
  Pl110 other(registers_address(), geometry, std::span(memory).first(memory.size() - 1));
  EXPECT_EQ(other.start(), hal::Status(hal::Error::invalid, hal::Part::buffer));
  EXPECT_EQ(registers, Registers{});
}

TEST(LcdFormats, FewerBitsMeanFewerColoursAndBytes) {
  for (const int bits : {1, 2, 4, 8}) {
    const Pl110::Geometry geometry{32, 4, bits};
    std::array<std::uint32_t, 256> registers{};
    std::vector<std::uint8_t> memory(Pl110::memory_bytes(geometry));
    Pl110 panel(reinterpret_cast<std::uintptr_t>(registers.data()), geometry, memory);
    ASSERT_TRUE(panel.start().ok());
    EXPECT_EQ(1 << (registers[control] >> 1U & 7U), bits);
    EXPECT_EQ(panel.buffer_stride(), 32 * bits / 8);
    EXPECT_EQ(panel.capabilities().palette_entries, 1 << bits);
    EXPECT_EQ(panel.capabilities().bit_order, hal::BitOrder::lsb_first);
    const std::vector<std::uint8_t> too_many(3U * ((std::size_t{1} << static_cast<unsigned>(bits)) + 1U));
    EXPECT_EQ(panel.show(0, too_many), hal::Status(hal::Error::invalid, hal::Part::palette));
  }
}

}  // namespace
