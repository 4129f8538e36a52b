// SPDX-License-Identifier: MIT
//
// Errors of mixtures of codes, against mixtures of light in 64 bits of fraction.
#include <host/lab/errors/report.hpp>
#include <tests/oracle/srgb.hpp>

#include <array>
#include <cmath>
#include <firmware/lab/families/ramp.hpp>

namespace {

struct RampErrors {
  using Family = lab::Ramp;
  using Case = std::array<std::int64_t, 4>;

  template <class Visit>
  static std::string cases(int load, host::lab::Effort effort, Visit&& visit) {
    if (load == 0) {
      for (std::int64_t part = 0; part < 16; ++part) visit(Case{0, 255, part, 15});
      return "all 16 greys";
    }
    // The greatest errors lie on long ramps.
    for (std::int64_t whole = 1; whole < 256; ++whole)
      for (std::int64_t part = 0; part <= whole; ++part) visit(Case{0, 255, part, whole});
    const std::int64_t stride = effort.stride(997);
    for (std::int64_t i = 0; i < 65536 * 241; i += stride) visit(Case{i >> 8 & 255, i & 255, i >> 16, 240});
    return "all pairs of codes in 240 steps, black to white in 1..255 steps";
  }
  template <class R>
  static long double error(int /*load*/, const Case& c) {
    static const auto lights = [] {
      std::array<long double, 256> light{};
      for (std::size_t code = 0; code < 256; ++code)
        light[code] = oracle::srgb_decode(static_cast<long double>(code) / 255);
      return light;
    }();
    const auto [from, to, part, whole] = c;
    const auto far = static_cast<long double>(part) / static_cast<long double>(whole);
    const long double start = lights.at(static_cast<std::size_t>(from));
    const long double light = start + (lights.at(static_cast<std::size_t>(to)) - start) * far;
    const std::uint8_t code = R{}(static_cast<std::uint8_t>(from), static_cast<std::uint8_t>(to),
                                  static_cast<int>(part), static_cast<int>(whole));
    return std::fabs(code - 255 * oracle::srgb_encode(light));
  }
};

}  // namespace

host::lab::FamilyReport host::lab::family_report() { return report<RampErrors>(); }
