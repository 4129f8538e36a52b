// SPDX-License-Identifier: MIT
//
// Random test input that repeats: a fixed seed, and a text to print with a failure.
#pragma once

#include <cstdint>
#include <random>
#include <string>

namespace oracle {

/// Random integers from a fixed seed.
class Random {
 public:
  explicit Random(std::uint32_t seed) : seed_(seed), engine_(seed) {}

  /// Evenly spread over low .. high, both included.
  int between(int low, int high) {
    return static_cast<int>(
        low + static_cast<std::int64_t>(
                  engine_() % (std::uint64_t{1} + static_cast<std::uint64_t>(std::int64_t{high} - low))));
  }
  std::uint64_t bits() { return engine_(); }
  /// A number of any size up to 64 bits, small and large ones alike, both signs.
  std::int64_t any_int64() {
    const auto shift = static_cast<unsigned>(engine_() % 64U);
    return static_cast<std::int64_t>(engine_()) >> shift;
  }
  /// As any_int64, 32 bits.
  std::int32_t any_int32() {
    const auto shift = static_cast<unsigned>(engine_() % 32U);
    return static_cast<std::int32_t>(engine_() >> 32U) >> shift;
  }

  [[nodiscard]] std::string seed_text() const { return "seed " + std::to_string(seed_); }

 private:
  std::uint32_t seed_;
  std::mt19937_64 engine_;
};

}  // namespace oracle
