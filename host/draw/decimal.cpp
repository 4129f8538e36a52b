// SPDX-License-Identifier: MIT
#include <host/draw/decimal.hpp>

#include <algorithm>
#include <cstdint>
#include <gmpxx.h>
#include <limits>
#include <string>
#include <vector>

namespace host::draw {
namespace {

constexpr std::int64_t largest = std::numeric_limits<int>::max();

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool all_digits(std::string_view text) { return std::all_of(text.begin(), text.end(), is_digit); }

/// Takes the sign off; true for minus.
bool take_minus(std::string_view& text) {
  const bool minus = text.starts_with('-');
  if (minus || text.starts_with('+')) text.remove_prefix(1);
  return minus;
}

/// The value of digits, saturated.
std::int64_t magnitude(std::string_view digits) {
  std::int64_t value = 0;
  for (const char digit : digits) value = std::min(value * 10 + (digit - '0'), largest);
  return value;
}

/// Doubles a decimal fraction in place; gives what crossed the point.
int twice(std::vector<int>& digits) {
  int carry = 0;
  for (auto digit = digits.rbegin(); digit != digits.rend(); ++digit) {
    const int doubled = *digit * 2 + carry;
    *digit = doubled % 10;
    carry = doubled / 10;
  }
  return carry;
}

/// 256 times the fraction with these digits, rounded, halves up: 0..256.
int rounded_256ths(std::string_view digits) {
  std::vector<int> fraction;
  for (const char digit : digits) fraction.push_back(digit - '0');
  int value = 0;
  for (int bit = 0; bit < 8; ++bit) value = value * 2 + twice(fraction);
  return value + twice(fraction);  // what crosses the point now is the half
}

int with_sign(std::int64_t value, bool minus) {
  const auto clamped = static_cast<int>(std::min(value, largest));
  return minus ? -clamped : clamped;
}

/// 256 times the fraction, rounded, halves up, saturated; nothing if it isn't one.
std::optional<std::int64_t> rounded_256ths(std::string_view upper, std::string_view lower) {
  if (upper.empty() || lower.empty() || !all_digits(upper) || !all_digits(lower)) return std::nullopt;
  const mpz_class numerator(std::string(upper), 10);
  const mpz_class denominator(std::string(lower), 10);
  if (denominator == 0) return std::nullopt;
  const mpz_class value = (512 * numerator + denominator) / (2 * denominator);
  return value > largest ? largest : std::int64_t{value.get_si()};
}

}  // namespace

std::optional<int> parse_whole(std::string_view text) {
  const bool minus = take_minus(text);
  if (text.empty() || !all_digits(text)) return std::nullopt;
  return with_sign(magnitude(text), minus);
}

std::optional<int> parse_subpixel(std::string_view text) {
  const bool minus = take_minus(text);
  if (const auto bar = text.find('/'); bar != std::string_view::npos) {
    const auto value = rounded_256ths(text.substr(0, bar), text.substr(bar + 1));
    return value ? std::optional(with_sign(*value, minus)) : std::nullopt;
  }
  const auto point = text.find('.');
  const std::string_view whole = text.substr(0, point);
  const std::string_view fraction = point == std::string_view::npos ? "" : text.substr(point + 1);
  if ((whole.empty() && fraction.empty()) || !all_digits(whole) || !all_digits(fraction)) return std::nullopt;
  return with_sign(magnitude(whole) * 256 + rounded_256ths(fraction), minus);
}

}  // namespace host::draw
