// SPDX-License-Identifier: MIT
#include <intaglio/text/utf8.hpp>

namespace intaglio::text {

char32_t take_code_point(std::string_view& utf8) noexcept {
  const char* at = utf8.data();
  const char* const end = at + utf8.size();
  const unsigned lead = static_cast<unsigned char>(*at++);
  // Table 3-7: the lead byte says how many follow and narrows the range of the second.
  int following = 0;
  unsigned lowest = 0x80;
  unsigned highest = 0xBF;
  char32_t code = lead;
  if (lead >= 0x80) {
    code = replacement_character;
    if (lead >= 0xC2 && lead < 0xE0) {
      following = 1;
      code = lead & 0x1FU;
    } else if (lead >= 0xE0 && lead < 0xF0) {
      following = 2;
      code = lead & 0x0FU;
      if (lead == 0xE0) lowest = 0xA0;   // less is overlong
      if (lead == 0xED) highest = 0x9F;  // more is a surrogate
    } else if (lead >= 0xF0 && lead < 0xF5) {
      following = 3;
      code = lead & 0x07U;
      if (lead == 0xF0) lowest = 0x90;   // less is overlong
      if (lead == 0xF4) highest = 0x8F;  // more is above U+10FFFF
    }
  }
  for (; following > 0; --following) {
    const unsigned next = at != end ? static_cast<unsigned char>(*at) : 0U;
    if (next < lowest || next > highest) {
      code = replacement_character;
      break;
    }
    code = code << 6U | (next & 0x3FU);
    ++at;
    lowest = 0x80;
    highest = 0xBF;
  }
  utf8 = {at, static_cast<std::string_view::size_type>(end - at)};
  return code;
}

}  // namespace intaglio::text
