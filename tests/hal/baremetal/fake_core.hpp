// SPDX-License-Identifier: MIT
//
// A processor core for tests of drivers on the desk: going to sleep runs whatever interrupt the test wants
// next.
#pragma once

#include <functional>

namespace fake_core {

/// Called when a driver sleeps; a test sets it. Sleeping without it ends the test program, for nothing would
/// ever wake the driver.
extern std::function<void()> on_sleep;
/// True between mask_interrupts and unmask_interrupts.
[[nodiscard]] bool masked();
/// Calls of `synchronise` so far.
[[nodiscard]] int synchronised();

}  // namespace fake_core
