// SPDX-License-Identifier: MIT
//
// The four memory functions that a compiler may call even in freestanding code. There is no other libc here.
// Rule: whole words while both ends allow it, bytes for the rest. Compiled with loop-pattern recognition off,
// or the compiler would turn each body into a call of itself.
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

void* memcpy(void* __restrict target, const void* __restrict source, std::size_t count) {
  auto* to = static_cast<unsigned char*>(target);
  const auto* from = static_cast<const unsigned char*>(source);
  if (word_aligned(to) && word_aligned(from))
    for (; count >= 4; count -= 4, to += 4, from += 4)
      *reinterpret_cast<Word*>(to) = *reinterpret_cast<const Word*>(from);
  for (; count != 0; --count) *to++ = *from++;
  return target;
}

void* memmove(void* target, const void* source, std::size_t count) {
  auto* to = static_cast<unsigned char*>(target);
  const auto* from = static_cast<const unsigned char*>(source);
  if (reinterpret_cast<std::uintptr_t>(to) - reinterpret_cast<std::uintptr_t>(from) >= count)
    return memcpy(target, source, count);
  while (count != 0) {
    --count;
    to[count] = from[count];
  }
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
