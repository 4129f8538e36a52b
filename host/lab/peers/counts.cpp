// SPDX-License-Identifier: MIT
#include <host/lab/peers/libfixmath.hpp>

#include <firmware/lab/count/kernel.hpp>

void count_peers() noexcept {
  lab::count_family<lab::PeerSine>();
  lab::count_family<lab::PeerTurns>();
  lab::count_family<lab::PeerSquareRoot>();
  lab::count_family<lab::PeerDivision>();
  lab::count_family<lab::PeerArcTangent>();
}
