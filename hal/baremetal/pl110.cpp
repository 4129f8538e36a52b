// SPDX-License-Identifier: MIT
#include <hal/baremetal/core.hpp>
#include <hal/baremetal/pl110.hpp>
#include <hal/baremetal/registers.hpp>

namespace hal::baremetal {

namespace {

enum Offset : std::uintptr_t {
  timing_0 = 0x00,
  timing_1 = 0x04,
  timing_2 = 0x08,
  upper_base = 0x10,
  control = 0x18,
  interrupt_mask = 0x1C,
  interrupt_status = 0x24,
  interrupt_clear = 0x28,
  palette_words = 0x200,
};

constexpr std::uint32_t next_base_update = 1U << 2U;
constexpr std::uint32_t control_enable = 1U << 0U;
constexpr std::uint32_t control_tft = 1U << 5U;
constexpr std::uint32_t control_power = 1U << 11U;

/// Palette word half: red in bits 4:0, green in 9:5, blue in 14:10.
constexpr std::uint16_t pack_555(const std::uint8_t* rgb) noexcept {
  return static_cast<std::uint16_t>(rgb[0] >> 3U | rgb[1] >> 3U << 5U | rgb[2] >> 3U << 10U);
}

/// The control register's code of a pixel size: log2 of it.
constexpr std::uint32_t size_code(int bits) noexcept {
  return bits == 8 ? 3U : bits == 4 ? 2U : bits == 2 ? 1U : 0U;
}

constexpr bool can_scan(const Capabilities& c) noexcept {
  const int bits = c.bits_per_pixel;
  return c.width >= 16 && c.width <= 1024 && c.width % 16 == 0 && c.height >= 1 && c.height <= 1024 &&
         (bits == 1 || bits == 2 || bits == 4 || bits == 8);
}

}  // namespace

Status Pl110::start() noexcept {
  const Capabilities& c = capabilities_;
  if (!can_scan(c)) return {Error::invalid, Part::panel};
  if (memory_.size() < memory_bytes({c.width, c.height, c.bits_per_pixel}))
    return {Error::invalid, Part::buffer};
  const auto width = static_cast<std::uint32_t>(c.width);
  const auto height = static_cast<std::uint32_t>(c.height);
  write_register(registers_ + control, 0);
  // Porches and pulses of a common 320x240 TFT; the sizes are what matters to an emulator.
  write_register(registers_ + timing_0, (width / 16 - 1) << 2U | 15U << 8U | 7U << 16U | 7U << 24U);
  write_register(registers_ + timing_1, (height - 1) | 3U << 10U | 5U << 16U | 3U << 24U);
  write_register(registers_ + timing_2, (width - 1) << 16U);
  write_register(registers_ + upper_base, buffer_address(0));
  write_register(registers_ + interrupt_mask, next_base_update);
  write_register(registers_ + control,
                 control_enable | size_code(c.bits_per_pixel) << 1U | control_tft | control_power);
  on_ = true;
  return {};
}

void Pl110::on_interrupt() noexcept {
  if ((read_register(registers_ + interrupt_status) & next_base_update) == 0) return;
  write_register(registers_ + interrupt_clear, next_base_update);
  requests_.on_vblank([this](int buffer, std::size_t colours, const auto& colour) noexcept {
    for (std::size_t i = 0; i < colours; i += 2) {
      const std::uintptr_t word = registers_ + palette_words + 2 * i;
      const std::uint32_t upper = i + 1 < colours ? static_cast<std::uint32_t>(colour(i + 1)) << 16U
                                                  : read_register(word) & 0xFFFF'0000U;
      write_register(word, upper | colour(i));
    }
    write_register(registers_ + upper_base, buffer_address(buffer));
  });
}

std::span<std::uint8_t> Pl110::do_buffer(int index) noexcept {
  const std::size_t bytes =
      static_cast<std::size_t>(do_buffer_stride()) * static_cast<std::size_t>(capabilities_.height);
  const std::size_t first = bytes * static_cast<std::size_t>(index);
  return memory_.size() < first + bytes ? std::span<std::uint8_t>{} : memory_.subspan(first, bytes);
}

std::uint32_t Pl110::buffer_address(int index) noexcept {
  return static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(do_buffer(index).data()));
}

Status Pl110::do_show(int index, std::span<const std::uint8_t> palette) noexcept {
  if (!on_) return {Error::unsupported, Part::panel};
  requests_.request(index, palette.size() / 3,
                    [palette](std::size_t i) noexcept { return pack_555(&palette[3 * i]); });
  return {};
}

bool Pl110::do_show_pending() noexcept { return requests_.pending(); }

Status Pl110::do_write(const Rect&, std::span<const std::uint8_t>, int) noexcept {
  return {Error::unsupported, Part::buffer};
}

// Even a palette alone waits for VBLANK: half a palette on display tears as half a frame does.
Status Pl110::do_load_palette(std::span<const std::uint8_t> palette) noexcept {
  if (do_show_pending()) return {Error::busy, Part::palette};
  return do_show(requests_.on_display(), palette);
}

std::uint32_t Pl110::do_vblank_count() noexcept { return requests_.vblanks(); }

Status Pl110::do_wait_for_vblank() noexcept {
  if (!on_) return {Error::timeout, Part::panel};
  const std::uint32_t before = do_vblank_count();
  sleep_until([&] { return do_vblank_count() != before; });
  return {};
}

}  // namespace hal::baremetal
