// SPDX-License-Identifier: MIT
//
// What only the device runs, checked on the device: the store-multiples of `image/fill.cpp` and the memory
// functions of the board, against loops of single bytes, for every alignment and length.
// The exit code is 0 if all is well, else the number of what is wrong, in the order of main.
#include <intaglio/image/fill.hpp>

#include <cstdint>
#include <cstring>
#include <firmware/boards/common/semihosting.hpp>

namespace {

constexpr unsigned places = 8;
constexpr unsigned lengths = 150;
constexpr unsigned bytes = places + lengths + 8;
constexpr std::uint8_t before = 0x5A;
constexpr std::uint8_t ink = 0xC3;

alignas(8) constinit std::uint8_t memory[bytes];
alignas(8) constinit std::uint8_t source[bytes];

// True if the bytes of a run, and no others, are what `expected(place in the run)` says.
template <class Write, class Expected>
bool exact(Write write, Expected expected) noexcept {
  for (unsigned begin = 0; begin < places; ++begin)
    for (unsigned length = 0; length < lengths; ++length) {
      for (volatile std::uint8_t& byte : memory) byte = before;
      write(memory + begin, length);
      for (unsigned i = 0; i < bytes; ++i) {
        const std::uint8_t wanted = i - begin < length ? expected(i - begin) : before;
        if (static_cast<volatile std::uint8_t*>(memory)[i] != wanted) return false;
      }
    }
  return true;
}

bool memmove_is_exact() noexcept {
  for (unsigned from = 0; from < places; ++from)
    for (unsigned to = 0; to < places; ++to)
      for (unsigned length = 0; length < lengths; ++length) {
        for (unsigned i = 0; i < bytes; ++i)
          static_cast<volatile std::uint8_t*>(memory)[i] = static_cast<std::uint8_t>(i);
        std::memmove(memory + to, memory + from, length);
        for (unsigned i = 0; i < bytes; ++i) {
          const unsigned wanted = i - to < length ? i - to + from : i;
          if (static_cast<volatile std::uint8_t*>(memory)[i] != wanted) return false;
        }
      }
  return true;
}

}  // namespace

int main() {
  namespace image = intaglio::image;
  for (unsigned i = 0; i < bytes; ++i)
    static_cast<volatile std::uint8_t*>(source)[i] = static_cast<std::uint8_t>(3 * i);

  const auto fill = [](std::uint8_t* first, unsigned length) {
    image::fill_bytes(first, static_cast<int>(length), image::Pattern(ink));
  };
  const auto flip = [](std::uint8_t* first, unsigned length) {
    image::flip_bytes(first, static_cast<int>(length), image::Pattern(ink));
  };
  const auto set = [](std::uint8_t* first, unsigned length) { std::memset(first, ink, length); };
  const auto copy = [](std::uint8_t* first, unsigned length) { std::memcpy(first, source, length); };
  const auto copy_askew = [](std::uint8_t* first, unsigned length) {
    std::memcpy(first, source + 1, length);
  };
  const auto inked = [](unsigned) { return ink; };

  const bool results[] = {
      exact(fill, inked),
      exact(flip, [](unsigned) { return static_cast<std::uint8_t>(before ^ ink); }),
      exact(set, inked),
      exact(copy, [](unsigned i) { return static_cast<std::uint8_t>(3 * i); }),
      exact(copy_askew, [](unsigned i) { return static_cast<std::uint8_t>(3 * i + 3); }),
      memmove_is_exact(),
  };
  int number = 0;
  for (const bool good : results) {
    ++number;
    if (!good) boards::semihosting::exit(number);
  }
  boards::semihosting::exit(0);
}
