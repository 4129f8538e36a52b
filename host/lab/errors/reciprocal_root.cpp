// SPDX-License-Identifier: MIT
//
// Errors of reciprocal square roots, against the largest r with r*r*n <= 2^62 in 128 bits.
#include <host/lab/errors/numbers.hpp>

#include <cmath>
#include <firmware/lab/families/reciprocal_root.hpp>

namespace {

struct ReciprocalRootErrors {
  using Family = lab::ReciprocalRoot;
  using Case = std::array<std::int64_t, 1>;

  template <class Visit>
  static std::string cases(int load, host::lab::Effort effort, Visit&& visit) {
    const auto all = [&](std::int64_t first, std::int64_t last) {
      for (std::int64_t n = first; n <= last; ++n) visit(Case{n});
    };
    if (load == 0 && effort.full()) {
      all(1, 0xFFFF'FFFF);
      return "all 2^32 - 1 numbers";
    }
    if (load == 0) {
      host::lab::visit_numbers(effort.random(10'000'000), visit);
      return host::lab::visited_numbers;
    }
    constexpr std::int64_t least = std::int64_t{1} << 27;
    if (effort.full()) {
      all(least, 2 * least - 1);
      return "all 2^27 numbers";
    }
    std::mt19937 engine(20261124);
    const std::int64_t points = effort.random(10'000'000);
    for (std::int64_t i = 0; i < points; ++i) visit(Case{least + static_cast<std::int64_t>(engine() >> 5U)});
    return "random (mt19937, seed 20261124)";
  }
  template <class R>
  static long double error(int /*load*/, const Case& c) {
    const std::int64_t exact = answer_to(c[0]);
    const std::int64_t off = std::int64_t{R{}(static_cast<std::uint32_t>(c[0]))} - exact;
    return off == 0 ? 0 : std::fabs(static_cast<long double>(off) / static_cast<long double>(exact)) * 1e6L;
  }

 private:
  /// The exact answer; begins at the last one, for most numbers come in order.
  static std::int64_t answer_to(std::int64_t n) {
    using Wide = __int128;
    constexpr std::int64_t near = 1000;
    static std::int64_t answer = 0;
    const auto fits = [n](std::int64_t r) { return Wide{r} * r * n <= Wide{1} << 62; };
    if (answer < near || !fits(answer - near) || fits(answer + near))
      answer = static_cast<std::int64_t>(0x1p31L / std::sqrt(static_cast<long double>(n)));
    while (!fits(answer)) --answer;
    while (fits(answer + 1)) ++answer;
    return answer;
  }
};

}  // namespace

host::lab::FamilyReport host::lab::family_report() { return report<ReciprocalRootErrors>(); }
