// SPDX-License-Identifier: MIT
//
// Runs of bytes. Words are stored only at addresses that are multiples of four, so this runs on cores that
// trap on others (Cortex-M0+, ARM926). The end of a run is stored by the bits of what remains: 16, 8, 4,
// 2, 1.
#include <intaglio/image/fill.hpp>

#include <cstddef>

namespace intaglio::image {
namespace {

constexpr std::uint32_t repeat(std::uint8_t value) noexcept { return value * 0x01010101U; }

[[nodiscard]] bool on_word(const std::uint8_t* p) noexcept {
  return (reinterpret_cast<std::uintptr_t>(p) & 3U) == 0;
}

// `p` is a multiple of four. The built-in copy is one instruction, and no breach of the aliasing rules.
void store_word(std::uint8_t* p, std::uint32_t word) noexcept {
  __builtin_memcpy(__builtin_assume_aligned(p, 4), &word, sizeof word);
}

[[nodiscard]] std::uint32_t load_word(const std::uint8_t* p) noexcept {
  std::uint32_t word = 0;
  __builtin_memcpy(&word, __builtin_assume_aligned(p, 4), sizeof word);
  return word;
}

// Stores the whole blocks of 32 bytes in `count`, from a multiple of four on; moves `first` behind them and
// leaves the rest in the low five bits of `count`. Precondition: count >= 32.
#if defined(__arm__)
// Compilers don't make a store-multiple of this by themselves, and it is worth a factor of four.
void fill_blocks(std::uint8_t*& first, int& count, std::uint32_t word) noexcept {
  register std::uint32_t a asm("r3") = word;
  register std::uint32_t b asm("r4") = word;
  register std::uint32_t c asm("r5") = word;
  register std::uint32_t d asm("r6") = word;
  asm volatile(
      ".syntax unified\n\t"
      "subs %1, #32\n"
      "1:\n\t"
      "stmia %0!, {r3, r4, r5, r6}\n\t"
      "stmia %0!, {r3, r4, r5, r6}\n\t"
      "subs %1, #32\n\t"
      "bpl 1b"
      : "+l"(first), "+l"(count)
      : "r"(a), "r"(b), "r"(c), "r"(d)
      : "memory", "cc");
}
#else
void fill_blocks(std::uint8_t*& first, int& count, std::uint32_t word) noexcept {
  for (; count >= 32; count -= 32)
    for (const std::uint8_t* const end = first + 32; first != end; first += 4) store_word(first, word);
}
#endif

template <class Ink>
void masked_run(const MaskedRun& run, std::uint8_t value) noexcept {
  if (run.length == 0) {
    Ink::put(*run.first, run.head & run.tail, value);
    return;
  }
  Ink::put(*run.first, run.head, value);
  Ink::run(run.first + 1, run.length - 1, value);
  if (run.tail != 0) Ink::put(run.first[run.length], run.tail, value);
}

template <class Ink>
void byte_rows(std::uint8_t* first, int count, int rows, int stride, std::uint8_t value) noexcept {
  if (count == stride) {
    Ink::run(first, count * rows, value);
    return;
  }
  for (; rows > 0; --rows, first += stride) Ink::run(first, count, value);
}

template <class Ink>
void masked_rows(MaskedRun run, int rows, int stride, std::uint8_t value) noexcept {
  if (run.head == 255 && run.tail == 0) {
    byte_rows<Ink>(run.first, run.length, rows, stride, value);
    return;
  }
  for (; rows > 0; --rows, run.first += stride) masked_run<Ink>(run, value);
}

}  // namespace

void fill_bytes(std::uint8_t* first, int count, std::uint8_t value) noexcept {
  if (count <= 0) return;
  while (!on_word(first)) {
    *first++ = value;
    if (--count == 0) return;
  }
  const std::uint32_t word = repeat(value);
  if (count >= 32) fill_blocks(first, count, word);
  const auto rest = static_cast<unsigned>(count);
  if ((rest & 16U) != 0) {
    for (int i = 0; i < 16; i += 4) store_word(first + i, word);
    first += 16;
  }
  if ((rest & 8U) != 0) {
    for (int i = 0; i < 8; i += 4) store_word(first + i, word);
    first += 8;
  }
  if ((rest & 4U) != 0) {
    store_word(first, word);
    first += 4;
  }
  if ((rest & 2U) != 0) {
    first[0] = value;
    first[1] = value;
    first += 2;
  }
  if ((rest & 1U) != 0) *first = value;
}

void flip_bytes(std::uint8_t* first, int count, std::uint8_t value) noexcept {
  for (; count > 0 && !on_word(first); --count) *first++ ^= value;
  const std::uint32_t word = repeat(value);
  for (; count >= 4; count -= 4) {
    store_word(first, load_word(first) ^ word);
    first += 4;
  }
  for (; count > 0; --count) *first++ ^= value;
}

void Replace::run(const MaskedRun& run, std::uint8_t value) noexcept { masked_run<Replace>(run, value); }
void Replace::rows(std::uint8_t* first, int count, int rows, int stride, std::uint8_t value) noexcept {
  byte_rows<Replace>(first, count, rows, stride, value);
}
void Replace::rows(const MaskedRun& run, int rows, int stride, std::uint8_t value) noexcept {
  masked_rows<Replace>(run, rows, stride, value);
}

void Flip::run(const MaskedRun& run, std::uint8_t value) noexcept { masked_run<Flip>(run, value); }
void Flip::rows(std::uint8_t* first, int count, int rows, int stride, std::uint8_t value) noexcept {
  byte_rows<Flip>(first, count, rows, stride, value);
}
void Flip::rows(const MaskedRun& run, int rows, int stride, std::uint8_t value) noexcept {
  masked_rows<Flip>(run, rows, stride, value);
}

}  // namespace intaglio::image
