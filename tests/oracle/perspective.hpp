// SPDX-License-Identifier: MIT
//
// A value along a line seen in perspective, in rational numbers: value/w and 1/w change evenly.
#pragma once

#include <cstdint>
#include <gmpxx.h>

namespace oracle {

/// The value at step `k` of `steps`.
inline mpq_class in_perspective(int from, int to, std::uint32_t from_depth, std::uint32_t to_depth, int steps,
                                int k) {
  mpq_class t(k, steps);
  t.canonicalize();
  const mpq_class w0 = from_depth;
  const mpq_class w1 = to_depth;
  const mpq_class value_over_w = (1 - t) * from / w0 + t * to / w1;
  const mpq_class one_over_w = (1 - t) / w0 + t / w1;
  return value_over_w / one_over_w;
}

/// The largest integer that isn't greater.
inline mpz_class rounded_down(const mpq_class& value) {
  mpz_class result;
  mpz_fdiv_q(result.get_mpz_t(), value.get_num_mpz_t(), value.get_den_mpz_t());
  return result;
}

}  // namespace oracle
