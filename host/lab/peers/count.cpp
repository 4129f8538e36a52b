// SPDX-License-Identifier: MIT
//
// The image that counts libfixmath and this library on a core in QEMU.
#include <firmware/lab/count/probe.hpp>

void count_peers() noexcept;

int main() {
  count_peers();
  lab::probe::finish();
}
