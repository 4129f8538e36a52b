// SPDX-License-Identifier: MIT
#include <hal/baremetal/text_output.hpp>

#include <array>
#include <cstddef>

namespace hal::baremetal {

void TextOutput::text(std::string_view s) noexcept {
  for (const char c : s) do_put(c);
}

void TextOutput::decimal(std::uint32_t value) noexcept {
  std::array<char, 10> digits{};  // 2^32 - 1 has ten
  std::size_t first = digits.size();
  do {
    digits[--first] = static_cast<char>('0' + value % 10);
    value /= 10;
  } while (value != 0);
  text({&digits[first], digits.size() - first});
}

void TextOutput::hex(std::uint32_t value) noexcept {
  for (unsigned shift = 32; shift != 0;) {
    shift -= 4;
    do_put("0123456789abcdef"[value >> shift & 15U]);
  }
}

}  // namespace hal::baremetal
