// SPDX-License-Identifier: MIT
//
// A plugin for QEMU that counts what a lab image executes between the messages it leaves in its mailbox
// (firmware/lab/count/mailbox.cpp).
//
//   qemu-system-... -plugin libqemu_counter.so,mailbox=ADDRESS,isa=thumb|arm|riscv,out=FILE
//
// Rule: one line a count, "instructions loads stores multiplies divides", then the numbers reported after it.
// An instruction counts when it is executed, a conditional one whose condition fails too; loads and stores
// are the accesses that happen, so one that moves four registers counts four. Multiplies and divides are told
// by their encoding: multiply-and-add counts as a multiply. QEMU's package has no header for plugins; the
// declarations below are of version 1 of its interface (QEMU 4.2 to 8). Counters are leaked: static objects
// would be destroyed before the emulator's last callback.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string_view>

extern "C" {

struct qemu_info_t;
struct qemu_plugin_tb;
struct qemu_plugin_insn;
using qemu_plugin_id_t = std::uint64_t;
using qemu_plugin_meminfo_t = std::uint32_t;

void qemu_plugin_register_vcpu_tb_trans_cb(qemu_plugin_id_t id,
                                           void (*callback)(qemu_plugin_id_t, qemu_plugin_tb*));
std::size_t qemu_plugin_tb_n_insns(const qemu_plugin_tb* block);
qemu_plugin_insn* qemu_plugin_tb_get_insn(const qemu_plugin_tb* block, std::size_t index);
const void* qemu_plugin_insn_data(const qemu_plugin_insn* instruction);
std::size_t qemu_plugin_insn_size(const qemu_plugin_insn* instruction);
void qemu_plugin_register_vcpu_insn_exec_inline(qemu_plugin_insn* instruction, int operation, void* counter,
                                                std::uint64_t addend);
void qemu_plugin_register_vcpu_mem_cb(qemu_plugin_insn* instruction,
                                      void (*callback)(unsigned, qemu_plugin_meminfo_t, std::uint64_t, void*),
                                      int registers, int accesses, void* data);
bool qemu_plugin_mem_is_store(qemu_plugin_meminfo_t access);

[[gnu::visibility("default")]] extern int qemu_plugin_version;
int qemu_plugin_version = 1;
[[gnu::visibility("default")]] int qemu_plugin_install(qemu_plugin_id_t id, const qemu_info_t* info,
                                                       int argument_count, char** arguments);

}  // extern "C"

namespace {

enum class Isa : std::uint8_t { thumb, arm, riscv };
enum class Kind : std::uint8_t { other, multiply, divide };

struct Counts {
  std::uint64_t instructions = 0, loads = 0, stores = 0, multiplies = 0, divides = 0;
};

struct Counter {
  Isa isa = Isa::thumb;
  std::uint64_t mailbox = 0;
  std::FILE* out = stdout;
  Counts now;
  Counts begun;
  bool counting = false;  // The first count has begun: before it, .bss is cleared, the mailbox too.
  std::uint32_t number = 0;
  unsigned bytes = 0;
};

Counter& counter = *new Counter;

Kind kind_of_thumb(std::uint32_t first, std::uint32_t second, std::size_t size) {
  if (size == 2) return (first & 0xFFC0U) == 0x4340U ? Kind::multiply : Kind::other;  // muls
  if ((first & 0xFF80U) == 0xFB00U) return Kind::multiply;                            // mul, mla, smmul, ...
  if ((first & 0xFF80U) == 0xFB80U) {                                                 // long multiply, divide
    return (second & 0xF0U) == 0xF0U ? Kind::divide : Kind::multiply;
  }
  return Kind::other;
}

Kind kind_of_arm(std::uint32_t word) {
  const bool multiply = (word & 0x0F00'00F0U) == 0x0000'0090U;  // mul, mla, umull, ...
  const bool halfword = (word & 0x0F90'0090U) == 0x0100'0080U;  // smulbb, smlabb, ...
  return multiply || halfword ? Kind::multiply : Kind::other;
}

Kind kind_of_riscv(std::uint32_t word, std::size_t size) {
  if (size != 4 || (word & 0xFE00'007FU) != 0x0200'0033U) return Kind::other;
  return (word >> 14U & 1U) != 0 ? Kind::divide : Kind::multiply;
}

Kind kind_of(const qemu_plugin_insn* instruction) {
  const std::size_t size = qemu_plugin_insn_size(instruction);
  std::uint32_t word = 0;
  std::memcpy(&word, qemu_plugin_insn_data(instruction), size);
  switch (counter.isa) {
    case Isa::thumb:
      return kind_of_thumb(word & 0xFFFFU, word >> 16U, size);
    case Isa::arm:
      return kind_of_arm(word);
    case Isa::riscv:
      return kind_of_riscv(word, size);
  }
  return Kind::other;
}

void receive(std::uint64_t message) {
  const Counts& now = counter.now;
  const Counts& begun = counter.begun;
  if (message == 1) {
    counter.begun = now;
    counter.counting = true;
  } else if (message == 2) {
    std::fprintf(counter.out, "%llu %llu %llu %llu %llu\n",
                 static_cast<unsigned long long>(now.instructions - begun.instructions),
                 static_cast<unsigned long long>(now.loads - begun.loads),
                 static_cast<unsigned long long>(now.stores - begun.stores),
                 static_cast<unsigned long long>(now.multiplies - begun.multiplies),
                 static_cast<unsigned long long>(now.divides - begun.divides));
  } else if (message == 3) {
    std::fprintf(counter.out, "done\n");
    std::fclose(counter.out);
    std::_Exit(0);
  } else if (message >= 256 && counter.counting) {
    counter.number |= static_cast<std::uint32_t>(message - 256) << (8U * counter.bytes);
    if (++counter.bytes == 4) {
      std::fprintf(counter.out, "%u\n", counter.number);
      counter.bytes = 0;
      counter.number = 0;
    }
  }
}

void on_access(unsigned /*core*/, qemu_plugin_meminfo_t access, std::uint64_t address, void* /*data*/) {
  if (!qemu_plugin_mem_is_store(access)) {
    ++counter.now.loads;
    return;
  }
  ++counter.now.stores;
  if (address - counter.mailbox < 512) receive(address - counter.mailbox);
}

void on_translation(qemu_plugin_id_t /*id*/, qemu_plugin_tb* block) {
  constexpr int add = 0;
  constexpr int no_registers = 0;
  constexpr int reads_and_writes = 3;
  const std::size_t count = qemu_plugin_tb_n_insns(block);
  for (std::size_t i = 0; i < count; ++i) {
    qemu_plugin_insn* instruction = qemu_plugin_tb_get_insn(block, i);
    qemu_plugin_register_vcpu_insn_exec_inline(instruction, add, &counter.now.instructions, 1);
    const Kind kind = kind_of(instruction);
    if (kind != Kind::other) {
      std::uint64_t& special = kind == Kind::multiply ? counter.now.multiplies : counter.now.divides;
      qemu_plugin_register_vcpu_insn_exec_inline(instruction, add, &special, 1);
    }
    qemu_plugin_register_vcpu_mem_cb(instruction, on_access, no_registers, reads_and_writes, nullptr);
  }
}

/// The value of an argument `name=value`, or nothing.
std::string_view value_of(std::string_view argument, std::string_view name) {
  if (!argument.starts_with(name) || argument.substr(name.size(), 1) != "=") return {};
  return argument.substr(name.size() + 1);
}

}  // namespace

int qemu_plugin_install(qemu_plugin_id_t id, const qemu_info_t* /*info*/, int argument_count,
                        char** arguments) {
  for (int i = 0; i < argument_count; ++i) {
    if (const auto address = value_of(arguments[i], "mailbox"); !address.empty()) {
      counter.mailbox = std::strtoull(address.data(), nullptr, 0);
    } else if (const auto isa = value_of(arguments[i], "isa"); !isa.empty()) {
      counter.isa = isa == "riscv" ? Isa::riscv : isa == "arm" ? Isa::arm : Isa::thumb;
    } else if (const auto file = value_of(arguments[i], "out"); !file.empty()) {
      counter.out = std::fopen(file.data(), "w");
      if (counter.out == nullptr) return 1;
    } else {
      return 1;
    }
  }
  if (counter.mailbox == 0) return 1;
  qemu_plugin_register_vcpu_tb_trans_cb(id, on_translation);
  return 0;
}
