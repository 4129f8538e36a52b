// SPDX-License-Identifier: MIT
//
// Errors of blends of 8 bits, against the quotient in floating point, at all arguments.
#include <host/lab/errors/report.hpp>

#include <cmath>
#include <firmware/lab/families/blend8.hpp>

namespace {

struct Blend8Errors {
  using Family = lab::Blend8;
  using Case = std::array<std::int64_t, 3>;

  template <class Visit>
  static std::string cases(int load, host::lab::Effort effort, Visit&& visit) {
    for (std::int64_t from = 0; from <= (load == 0 ? 255 : 0); from += load == 0 ? effort.stride(17) : 1) {
      for (std::int64_t to = 0; to <= 255; ++to) {
        for (std::int64_t alpha = 0; alpha <= 255; ++alpha) visit(Case{from, to, alpha});
      }
    }
    return load == 0 ? (effort.full() ? "all 2^24 arguments" : "every 17th from") : "all 65,536 products";
  }
  template <class R>
  static long double error(int /*load*/, const Case& c) {
    const auto [from, to, alpha] = c;
    const long double exact = static_cast<long double>(from * (255 - alpha) + to * alpha) / 255;
    const auto in = [](std::int64_t value) { return static_cast<std::uint8_t>(value); };
    return std::fabs(static_cast<long double>(R{}(in(from), in(to), in(alpha))) - exact);
  }
};

}  // namespace

host::lab::FamilyReport host::lab::family_report() { return report<Blend8Errors>(); }
