// SPDX-License-Identifier: MIT
//
// Oracle for UTF-8: every Unicode scalar value is encoded by the definition, and a byte string is decoded by
// looking its prefixes up in that set. Nothing is known here about lead bytes and their ranges; "maximal
// subpart" is taken literally: the longest prefix that some encoding begins with.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace oracle {

inline std::string encode_utf8(std::uint32_t code) {
  const auto byte = [](std::uint32_t b) { return static_cast<char>(static_cast<unsigned char>(b)); };
  if (code < 0x80) return {byte(code)};
  if (code < 0x800) return {byte(192 + code / 64), byte(128 + code % 64)};
  if (code < 0x10000) return {byte(224 + code / 4096), byte(128 + code / 64 % 64), byte(128 + code % 64)};
  return {byte(240 + code / 262144), byte(128 + code / 4096 % 64), byte(128 + code / 64 % 64),
          byte(128 + code % 64)};
}

class Utf8 {
 public:
  Utf8() {
    for (std::uint32_t code = 0; code <= 0x10FFFF; ++code) {
      if (code >= 0xD800 && code <= 0xDFFF) continue;
      const std::string bytes = encode_utf8(code);
      whole_[key(bytes)] = code;
      for (std::size_t n = 1; n < bytes.size(); ++n) beginning_.insert(key(bytes.substr(0, n)));
    }
  }

  std::vector<std::uint32_t> decode(std::string_view text) const {
    std::vector<std::uint32_t> codes;
    while (!text.empty()) {
      std::size_t taken = 0;
      std::uint32_t code = 0xFFFD;
      for (std::size_t n = 1; n <= 4 && n <= text.size(); ++n) {
        const std::uint64_t prefix = key(text.substr(0, n));
        if (const auto found = whole_.find(prefix); found != whole_.end()) {
          taken = n;
          code = found->second;
          break;
        }
        if (!beginning_.contains(prefix)) break;
        taken = n;
      }
      if (taken == 0) taken = 1;
      codes.push_back(code);
      text.remove_prefix(taken);
    }
    return codes;
  }

 private:
  /// Bytes and their number as one integer.
  static std::uint64_t key(std::string_view bytes) {
    std::uint64_t k = bytes.size();
    for (const char c : bytes) k = k * 256 + static_cast<unsigned char>(c);
    return k;
  }

  std::unordered_map<std::uint64_t, std::uint32_t> whole_;
  std::unordered_set<std::uint64_t> beginning_;
};

/// One for all tests, as its tables are large.
inline const Utf8& utf8_by_definition() {
  static const Utf8 instance;
  return instance;
}

}  // namespace oracle
