// SPDX-License-Identifier: MIT
#include <hal/baremetal/core.hpp>
#include <tests/hal/baremetal/fake_core.hpp>

#include <cstdio>
#include <cstdlib>

namespace {

bool masked_now = false;
int synchronised_so_far = 0;

}  // namespace

namespace fake_core {

std::function<void()> on_sleep;
bool masked() { return masked_now; }
int synchronised() { return synchronised_so_far; }

}  // namespace fake_core

namespace hal::baremetal {

void mask_interrupts() noexcept { masked_now = true; }
void unmask_interrupts() noexcept { masked_now = false; }
void synchronise() noexcept { ++synchronised_so_far; }
void wait_for_interrupt() noexcept {
  if (!fake_core::on_sleep) {
    std::fputs("a driver sleeps, and no interrupt is to come\n", stderr);
    std::abort();
  }
  fake_core::on_sleep();
}

}  // namespace hal::baremetal
