// SPDX-License-Identifier: MIT
//
// Runs of bytes. Words are stored only at addresses that are multiples of four, so this runs on cores that
// trap on others (Cortex-M0+, ARM926). The end of a run is stored by the bits of what remains: 16, 8, 4,
// 2, 1.
#include <intaglio/image/fill.hpp>

#include <cstddef>

namespace intaglio::image {
namespace {

[[nodiscard]] unsigned place_in_word(const std::uint8_t* p) noexcept {
  return static_cast<unsigned>(reinterpret_cast<std::uintptr_t>(p) & 3U);
}

// `p` is a multiple of two.
void store_pair(std::uint8_t* p, Pattern pattern) noexcept {
  const auto pair = static_cast<std::uint16_t>(pattern.word());
  __builtin_memcpy(__builtin_assume_aligned(p, 2), &pair, sizeof pair);
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

// Inlined, optimising for size too: four instructions.
[[gnu::always_inline]] inline void copy_but(std::uint8_t* to, std::uint8_t byte, Pattern pattern) noexcept {
  if (byte != pattern.byte()) *to = byte;
}

// Stores `count` >= 0 bytes from a multiple of four on.
#if defined(__arm__)
// Compilers don't make store-multiples of this by themselves, and they are worth a factor of four. Blocks of
// 32 bytes, then the rest by the bits of its length, two at a time: a shift to the left by 28 puts bit 4 into
// the carry and bit 3 into the sign.
void fill_from_word(std::uint8_t* first, int count, Pattern pattern) noexcept {
  register std::uint32_t a asm("r3") = pattern.word();
  register std::uint32_t b asm("r4") = pattern.word();
  register std::uint32_t c asm("r5") = pattern.word();
  register std::uint32_t d asm("r6") = pattern.word();
  int bits = 0;
  asm volatile(
      ".syntax unified\n\t"
      "subs %[count], #32\n\t"
      "blo 2f\n"
      "1:\n\t"
      "stmia %[first]!, {r3, r4, r5, r6}\n\t"
      "stmia %[first]!, {r3, r4, r5, r6}\n\t"
      "subs %[count], #32\n\t"
      "bhs 1b\n"
      "2:\n\t"
      "lsls %[bits], %[count], #28\n\t"
      "bcc 3f\n\t"
      "stmia %[first]!, {r3, r4, r5, r6}\n"
      "3:\n\t"
      "bpl 4f\n\t"
      "stmia %[first]!, {r3, r4}\n"
      "4:\n\t"
      "lsls %[bits], %[count], #30\n\t"
      "bcc 5f\n\t"
      "stmia %[first]!, {r3}\n"
      "5:\n\t"
      "bpl 6f\n\t"
      "strh r3, [%[first]]\n\t"
      "adds %[first], #2\n"
      "6:\n\t"
      "lsls %[bits], %[count], #31\n\t"
      "beq 7f\n\t"
      "strb r3, [%[first]]\n"
      "7:"
      : [first] "+l"(first), [count] "+l"(count), [bits] "=&l"(bits)
      : "r"(a), "r"(b), "r"(c), "r"(d)
      : "memory", "cc");
}
#else
void fill_from_word(std::uint8_t* first, int count, Pattern pattern) noexcept {
  for (; count >= 16; count -= 16)
    for (const std::uint8_t* const end = first + 16; first != end; first += 4)
      store_word(first, pattern.word());
  for (; count >= 4; count -= 4, first += 4) store_word(first, pattern.word());
  for (; count > 0; --count) *first++ = pattern.byte();
}
#endif

template <class Ink>
void masked_run(const MaskedRun& run, Pattern pattern) noexcept {
  if (run.length == 0) {
    Ink::put(*run.first, run.head & run.tail, pattern);
    return;
  }
  Ink::put(*run.first, run.head, pattern);
  Ink::run(run.first + 1, run.length - 1, pattern);
  if (run.tail != 0) Ink::put(run.first[run.length], run.tail, pattern);
}

template <class Ink>
void byte_rows(std::uint8_t* first, int count, int rows, int stride, Pattern pattern) noexcept {
  if (count == stride) {
    Ink::run(first, count * rows, pattern);
    return;
  }
  // Not stepped behind the last row: that place may lie outside the buffer.
  while (true) {
    Ink::run(first, count, pattern);
    if (--rows == 0) return;
    first += stride;
  }
}

template <class Ink>
void masked_rows(MaskedRun run, int rows, int stride, Pattern pattern) noexcept {
  if (run.head == 255 && run.tail == 0) {
    byte_rows<Ink>(run.first, run.length, rows, stride, pattern);
    return;
  }
  while (true) {
    masked_run<Ink>(run, pattern);
    if (--rows == 0) return;
    run.first += stride;
  }
}

}  // namespace

void fill_bytes(std::uint8_t* first, int count, Pattern pattern) noexcept {
  const unsigned misplaced = place_in_word(first);
  if (misplaced != 0) {
    const auto byte = pattern.byte();
    if (count < 4) {
      for (; count > 0; --count) *first++ = byte;
      return;
    }
    if ((misplaced & 1U) != 0) {
      *first++ = byte;
      --count;
    }
    // 1, now 2, and 2 lack a pair of bytes to the next word; 3, now 0, doesn't.
    if (misplaced != 3) {
      store_pair(first, pattern);
      first += 2;
      count -= 2;
    }
  }
  fill_from_word(first, count, pattern);
}

void flip_bytes(std::uint8_t* first, int count, Pattern pattern) noexcept {
  const auto byte = pattern.byte();
  for (; count > 0 && place_in_word(first) != 0; --count) *first++ ^= byte;
  for (; count >= 4; count -= 4, first += 4) store_word(first, load_word(first) ^ pattern.word());
  for (; count > 0; --count) *first++ ^= byte;
}

void copy_bytes_but(std::uint8_t* first, const std::uint8_t* source, int count, Pattern pattern) noexcept {
  if (place_in_word(first) == place_in_word(source)) {
    for (; count > 0 && place_in_word(first) != 0; --count) copy_but(first++, *source++, pattern);
    for (; count >= 4; count -= 4, first += 4, source += 4) {
      const std::uint32_t word = load_word(source);
      const std::uint32_t difference = word ^ pattern.word();
      if (difference == 0) continue;
      // The bytes that differ get their highest bit set, and then all bits.
      constexpr std::uint32_t low = 0x7F7F'7F7FU;
      const std::uint32_t high = (((difference & low) + low) | difference) & ~low;
      const std::uint32_t mask = (high << 1U) - (high >> 7U);
      const std::uint32_t below = load_word(first);
      store_word(first, below ^ ((below ^ word) & mask));
    }
  }
  for (; count >= 4; count -= 4, first += 4, source += 4) {
    copy_but(first, source[0], pattern);
    copy_but(first + 1, source[1], pattern);
    copy_but(first + 2, source[2], pattern);
    copy_but(first + 3, source[3], pattern);
  }
  for (; count > 0; --count) copy_but(first++, *source++, pattern);
}

void map_bytes(std::uint8_t* first, const std::uint8_t* source, int count,
               const std::uint8_t* table) noexcept {
  for (; count >= 8; count -= 8, first += 8, source += 8) {
    first[0] = table[source[0]];
    first[1] = table[source[1]];
    first[2] = table[source[2]];
    first[3] = table[source[3]];
    first[4] = table[source[4]];
    first[5] = table[source[5]];
    first[6] = table[source[6]];
    first[7] = table[source[7]];
  }
  for (; count > 0; --count) *first++ = table[*source++];
}

void Replace::run(const MaskedRun& run, Pattern pattern) noexcept { masked_run<Replace>(run, pattern); }
void Replace::rows(std::uint8_t* first, int count, int rows, int stride, Pattern pattern) noexcept {
  byte_rows<Replace>(first, count, rows, stride, pattern);
}
void Replace::rows(const MaskedRun& run, int rows, int stride, Pattern pattern) noexcept {
  masked_rows<Replace>(run, rows, stride, pattern);
}

void Flip::run(const MaskedRun& run, Pattern pattern) noexcept { masked_run<Flip>(run, pattern); }
void Flip::rows(std::uint8_t* first, int count, int rows, int stride, Pattern pattern) noexcept {
  byte_rows<Flip>(first, count, rows, stride, pattern);
}
void Flip::rows(const MaskedRun& run, int rows, int stride, Pattern pattern) noexcept {
  masked_rows<Flip>(run, rows, stride, pattern);
}

}  // namespace intaglio::image
