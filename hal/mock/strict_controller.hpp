// SPDX-License-Identifier: MIT
//
// Display controllers as seen from their bus, for testing drivers: they take the bytes of commands and data
// as the chip would and report, as failures of the running GoogleTest test or to whom `on_breach` names,
// every breach of the protocol:
// - bytes sent before the data/command line was ever driven, or a change of it inside a command;
// - a command while the last waits for its parameters, or data that no command asked for;
// - unknown commands and parameters out of range;
// - over I2C: another address, no or unknown control byte, or nothing behind it.
//
// Rule: a model follows the data sheet, not a driver; it shares no code with the drivers it tests. What a
// fault of the bus has torn is no breach of the driver's: what is left of a command after it is forgotten
// (parameters as data) or swallows what comes (parameters as commands) without effect.
#pragma once

#include <hal/bus.hpp>
#include <hal/mock/pattern.hpp>
#include <hal/pin.hpp>

#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace hal::mock {

class StrictController {
 public:
  StrictController(const StrictController&) = delete;
  StrictController& operator=(const StrictController&) = delete;
  virtual ~StrictController() = default;

  /// The ends of the wires.
  [[nodiscard]] SpiBus& spi() { return spi_; }
  [[nodiscard]] OutputPin& data_command() { return pin_; }
  [[nodiscard]] I2cBus& i2c() { return i2c_; }

  /// What a viewer sees: everything 0 while the display is off.
  [[nodiscard]] virtual Pattern displayed() const = 0;

  /// The row of the glass, from the top, that is refreshed after `step` others.
  [[nodiscard]] virtual int beam_row(int step) const = 0;

  /// Reports a breach if a command is still waiting for parameters.
  void expect_idle() const;
  /// Breaches are told to `report` and no longer fail the test.
  void on_breach(std::function<void(std::string_view)> report) { report_ = std::move(report); }

  /// After this many more transfers (bus or pin) every one fails with `Error::bus`, until this is called
  /// again. The first takes `bytes` of its bytes before it fails, the others none.
  void fail_after(int transfers, int bytes = 0) {
    transfers_left_ = transfers;
    torn_bytes_ = bytes;
  }
  /// Transfers so far.
  [[nodiscard]] int transfers() const { return transfers_; }
  /// Command and data bytes so far.
  [[nodiscard]] std::uint64_t command_bytes() const { return command_bytes_; }
  [[nodiscard]] std::uint64_t data_bytes() const { return data_bytes_; }

 protected:
  /// How parameters of commands travel.
  enum class Parameters : std::uint8_t { as_commands, as_data };
  explicit StrictController(std::uint8_t i2c_address, Parameters travel = Parameters::as_commands)
      : i2c_address_(i2c_address), travel_(travel) {}
  /// Parameters that a command takes; below 0: there is no such command.
  [[nodiscard]] virtual int parameters(std::uint8_t command) const = 0;
  /// A whole command with its parameters.
  virtual void execute(std::uint8_t command, const std::vector<std::uint8_t>& parameters) = 0;
  /// A byte for the display memory.
  virtual void store(std::uint8_t byte) = 0;

  /// What memory holds at power-on.
  [[nodiscard]] static std::vector<std::uint8_t> noise_bytes(unsigned seed, std::size_t size);
  /// Reports a breach of the protocol.
  void breach(std::string_view what) const;
  /// Reports a parameter outside low .. high; true if it is inside.
  bool in_range(std::uint8_t command, int value, int low, int high) const;
  /// True once after a fault of the bus: what was under way then is incomplete.
  [[nodiscard]] bool take_fault() { return std::exchange(fault_, false); }

 private:
  class Spi final : public SpiBus {
   public:
    explicit Spi(StrictController& owner) : owner_(&owner) {}

   private:
    Status do_write(std::span<const std::uint8_t> bytes) noexcept override;
    StrictController* owner_;
  };
  class Pin final : public OutputPin {
   public:
    explicit Pin(StrictController& owner) : owner_(&owner) {}

   private:
    Status do_set(bool high) noexcept override;
    StrictController* owner_;
  };
  class I2c final : public I2cBus {
   public:
    explicit I2c(StrictController& owner) : owner_(&owner) {}

   private:
    Status do_write(std::uint8_t address, std::span<const std::uint8_t> prefix,
                    std::span<const std::uint8_t> bytes) noexcept override;
    StrictController* owner_;
  };
  enum class Line : std::uint8_t { unknown, command, data };

  /// False if the transfer is to fail.
  bool begin_transfer();
  Status fail(Part part);
  /// Bytes of `count` that the failing transfer takes.
  [[nodiscard]] std::size_t torn(std::size_t count);
  void take(bool data, std::uint8_t byte);
  void take_command(std::uint8_t byte);
  void take_data(std::uint8_t byte);
  void take_parameter(std::uint8_t byte);
  /// Executes the command if it has all its parameters.
  void execute_if_complete();

  Spi spi_{*this};
  Pin pin_{*this};
  I2c i2c_{*this};
  std::uint8_t i2c_address_;
  Parameters travel_;
  std::function<void(std::string_view)> report_;
  Line line_ = Line::unknown;
  std::vector<std::uint8_t> command_;  // The command being taken in, with its parameters so far.
  int transfers_ = 0;
  int transfers_left_ = std::numeric_limits<int>::max();
  int torn_bytes_ = 0;
  bool fault_ = false;
  bool torn_command_ = false;  // The command being taken in was cut by a fault.
  std::uint64_t command_bytes_ = 0;
  std::uint64_t data_bytes_ = 0;
};

}  // namespace hal::mock
