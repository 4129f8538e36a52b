// SPDX-License-Identifier: MIT
//
// 32-bit numbers among which functions of one go wrong first.
#pragma once

#include <host/lab/errors/report.hpp>

#include <array>
#include <cstdint>
#include <random>

namespace host::lab {

/// Visits, from 1 to 2^32 - 1: all numbers below 2^16; all squares and numbers half-way between them, with
/// their neighbours; the ends of the cells of tables that 8 leading bits index; and random ones of all
/// lengths.
template <class Visit>
void visit_numbers(std::int64_t random, Visit&& visit) {
  constexpr std::int64_t last = 0xFFFFFFFF;
  const auto visit_around = [&](std::int64_t n) {
    for (std::int64_t near = n - 1; near <= n + 1; ++near) {
      if (near >= 1 && near <= last) visit(std::array{near});
    }
  };
  for (std::int64_t n = 1; n < 65536; ++n) visit(std::array{n});
  for (std::int64_t root = 1; root < 65536; ++root) {
    visit_around(root * root);
    visit_around(root * root + root);
  }
  for (int shift = 0; shift < 32; ++shift) {
    for (std::int64_t cell = 64; cell <= 256; ++cell) visit_around((cell << 24) >> shift);
  }
  std::mt19937 engine(20261123);
  for (std::int64_t i = 0; i < random; ++i) {
    const std::int64_t n = static_cast<std::int64_t>(engine()) >> (i % 32);
    visit(std::array{n == 0 ? last : n});
  }
}
inline constexpr const char* visited_numbers =
    "below 2^16, squares, half-way between, table cells, random (mt19937, seed 20261123)";

}  // namespace host::lab
