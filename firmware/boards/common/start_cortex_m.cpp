// SPDX-License-Identifier: MIT
//
// Start-up of Cortex-M boards: the vector table, .data and .bss, then main. No static constructors are run;
// the linker script refuses an image that has any.
#include <cstdint>

extern "C" {

extern std::uint32_t link_data_begin, link_data_end, link_data_load, link_bss_begin, link_bss_end;
extern std::uint32_t link_stack_top;

int main();
/// The board's handlers; a board without them gets these.
[[gnu::weak]] void handle_systick() {}
[[gnu::weak]] void handle_fault() {}

[[noreturn]] void reset_handler() {
  const std::uint32_t* from = &link_data_load;
  for (std::uint32_t* to = &link_data_begin; to < &link_data_end;) *to++ = *from++;
  for (std::uint32_t* to = &link_bss_begin; to < &link_bss_end;) *to++ = 0;
  main();
  for (;;) asm volatile("wfi");
}

[[noreturn]] void fault_handler() {
  handle_fault();
  for (;;) asm volatile("wfi");
}
}

namespace {

union Vector {
  std::uint32_t* stack;
  void (*handler)();
};

// Stack, reset, NMI, the faults, four reserved, SVCall, debug, reserved, PendSV, SysTick.
[[gnu::section(".vectors"), gnu::used]] constinit const Vector vectors[16] = {
    {.stack = &link_stack_top}, {.handler = reset_handler}, {.handler = fault_handler},
    {.handler = fault_handler}, {.handler = fault_handler}, {.handler = fault_handler},
    {.handler = fault_handler}, {.handler = nullptr},       {.handler = nullptr},
    {.handler = nullptr},       {.handler = nullptr},       {.handler = fault_handler},
    {.handler = fault_handler}, {.handler = nullptr},       {.handler = fault_handler},
    {.handler = handle_systick}};

}  // namespace
