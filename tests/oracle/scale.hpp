// SPDX-License-Identifier: MIT
//
// Oracle: which source pixel a scaled picture shows, straight from the rule: the centre of the destination
// pixel, (offset + 1/2) / to of the way, lies in source pixel i if i/from <= (offset + 1/2)/to < (i+1)/from.
#pragma once

#include <tests/oracle/integer.hpp>

namespace oracle {

/// The source pixel of `from` that pixel `offset` of `to` shows.
inline int scaled_source(int offset, int from, int to) {
  return static_cast<int>(floor_quotient((Wide{2} * offset + 1) * from, Wide{2} * to));
}

}  // namespace oracle
