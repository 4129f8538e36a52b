// SPDX-License-Identifier: MIT
//
// The four memory functions that a compiler may call even in freestanding code. There is no other libc here.
// Rule: whole words wherever the target is aligned, bytes for the rest. Where the source isn't aligned with
// it, a word is joined from two, so no core ever reads or writes a word at another address; the words read
// hold at least one byte of the source each. Little-endian. Compiled with loop-pattern recognition off, or
// the compiler would turn each body into a call of itself.
#include <cstddef>
#include <cstdint>

namespace {

using Word [[gnu::may_alias]] = std::uint32_t;

bool word_aligned(const void* p) noexcept { return (reinterpret_cast<std::uintptr_t>(p) & 3U) == 0; }

}  // namespace

extern "C" {

void* memset(void* target, int value, std::size_t count) {
  auto* to = static_cast<unsigned char*>(target);
  const auto byte = static_cast<unsigned char>(value);
  for (; count != 0 && !word_aligned(to); --count) *to++ = byte;
  for (const std::uint32_t word = byte * 0x0101'0101U; count >= 4; count -= 4, to += 4)
    *reinterpret_cast<Word*>(to) = word;
  for (; count != 0; --count) *to++ = byte;
  return target;
}

// Upwards; the target may overlap the source from below.
void* memcpy(void* target, const void* source, std::size_t count) {
  auto* to = static_cast<unsigned char*>(target);
  const auto* from = static_cast<const unsigned char*>(source);
  for (; count != 0 && !word_aligned(to); --count) *to++ = *from++;
  if (word_aligned(from)) {
    for (; count >= 4; count -= 4, to += 4, from += 4)
      *reinterpret_cast<Word*>(to) = *reinterpret_cast<const Word*>(from);
  } else if (count >= 4) {
    const std::uintptr_t ahead = reinterpret_cast<std::uintptr_t>(from) & 3U;
    const auto* words = reinterpret_cast<const Word*>(from - ahead);
    const auto shift = static_cast<std::uint32_t>(ahead) * 8U;
    for (std::uint32_t low = *words; count >= 4; count -= 4, to += 4, from += 4) {
      const std::uint32_t high = *++words;
      *reinterpret_cast<Word*>(to) = low >> shift | high << (32U - shift);
      low = high;
    }
  }
  for (; count != 0; --count) *to++ = *from++;
  return target;
}

void* memmove(void* target, const void* source, std::size_t count) {
  auto* const to = static_cast<unsigned char*>(target);
  const auto* const from = static_cast<const unsigned char*>(source);
  if (reinterpret_cast<std::uintptr_t>(to) - reinterpret_cast<std::uintptr_t>(from) >= count)
    return memcpy(target, source, count);
  for (; count != 0 && !word_aligned(to + count); --count) to[count - 1] = from[count - 1];
  if (word_aligned(from + count)) {
    for (; count >= 4; count -= 4)
      *reinterpret_cast<Word*>(to + count - 4) = *reinterpret_cast<const Word*>(from + count - 4);
  }
  for (; count != 0; --count) to[count - 1] = from[count - 1];
  return target;
}

int memcmp(const void* left, const void* right, std::size_t count) {
  const auto* a = static_cast<const unsigned char*>(left);
  const auto* b = static_cast<const unsigned char*>(right);
  for (; count != 0; --count, ++a, ++b)
    if (*a != *b) return *a < *b ? -1 : 1;
  return 0;
}
}
