// SPDX-License-Identifier: MIT
//
// Devices behind files of the kernel, above a kernel that isn't there.
#include <hal/linux/i2c_device.hpp>
#include <hal/linux/monotonic_clock.hpp>
#include <hal/linux/spi_device.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cerrno>
#include <linux/i2c-dev.h>
#include <linux/i2c.h>
#include <linux/spi/spidev.h>
#include <numeric>
#include <vector>

namespace {

using hal::Error;
using hal::Part;
using hal::Status;
using hal::linux_io::DeviceError;
using hal::linux_io::I2cDevice;
using hal::linux_io::SpiDevice;
using hal::linux_io::System;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

using Bytes = std::vector<std::uint8_t>;

Bytes counting(std::size_t size) {
  Bytes bytes(size);
  std::iota(bytes.begin(), bytes.end(), std::uint8_t{0});
  return bytes;
}

/// One device, open at most once.
class OneDevice : public System {
 public:
  ~OneDevice() override { EXPECT_EQ(open_files, 0) << "files are still open"; }
  int open(const char*, int) override {
    if (open_error != 0) return fail(open_error);
    ++open_files;
    return 7;
  }
  int close(int file) override {
    EXPECT_EQ(file, 7);
    --open_files;
    return 0;
  }
  static int fail(int error) {
    errno = error;
    return -1;
  }
  int open_error = 0;
  int open_files = 0;
};

template <class Make>
std::string refusal(Make make) {
  try {
    make();
  } catch (const DeviceError& error) {
    return error.what();
  }
  return "it was accepted";
}

/// spidev, as drivers/spi/spidev.c has it: a write longer than bufsiz is refused whole.
class Spidev final : public OneDevice {
 public:
  int ioctl(int, unsigned long request, void* argument) override {
    if (request == refused) return fail(refused_error);
    if (request == SPI_IOC_WR_MODE) mode = *static_cast<std::uint8_t*>(argument);
    if (request == SPI_IOC_WR_MAX_SPEED_HZ) hertz = *static_cast<std::uint32_t*>(argument);
    if (request == SPI_IOC_WR_BITS_PER_WORD) bits = *static_cast<std::uint8_t*>(argument);
    return 0;
  }
  ssize_t write(int, const void* bytes, std::size_t size) override {
    if (errors_at > 0 && --errors_at == 0) return fail(error);
    if (size > bufsiz) return fail(EMSGSIZE);
    const auto taken = std::min(size, most_at_once);
    const auto* const first = static_cast<const std::uint8_t*>(bytes);
    received.insert(received.end(), first, first + taken);
    transfers.push_back(taken);
    return static_cast<ssize_t>(taken);
  }
  std::string text_of(const std::string& path) override {
    EXPECT_EQ(path, "/sys/module/spidev/parameters/bufsiz");
    return told_bufsiz;
  }

  std::string told_bufsiz = "4096";
  std::size_t bufsiz = 4096;
  std::size_t most_at_once = 1U << 30U;
  unsigned long refused = 0;
  int refused_error = EINVAL;
  int errors_at = 0;
  int error = 0;
  int mode = -1;
  std::uint32_t hertz = 0;
  int bits = 0;
  Bytes received;
  std::vector<std::size_t> transfers;
};

TEST(Spi, IsSetUpAsAskedFor) {
  Spidev kernel;
  SpiDevice spi("/dev/spidev0.0", {32'000'000, 3}, kernel);
  EXPECT_EQ(kernel.mode, 3);
  EXPECT_EQ(kernel.hertz, 32'000'000U);
  EXPECT_EQ(kernel.bits, 8);
}

TEST(Spi, LongWritesAreCutToWhatTheDriverTakes) {
  Spidev kernel;
  SpiDevice spi("/dev/spidev0.0", {}, kernel);
  const Bytes bytes = counting(10'000);
  EXPECT_TRUE(spi.write(bytes).ok());
  EXPECT_EQ(kernel.received, bytes);
  EXPECT_THAT(kernel.transfers, ElementsAre(4096U, 4096U, 1808U));
}

TEST(Spi, ADriverThatTakesLessThanItSaysIsFollowed) {
  for (const char* const told : {"4096", "", "0", "nonsense", "65536"}) {
    Spidev kernel;
    kernel.told_bufsiz = told;
    kernel.bufsiz = 1000;
    SpiDevice spi("/dev/spidev0.0", {}, kernel);
    const Bytes bytes = counting(5'000);
    EXPECT_TRUE(spi.write(bytes).ok()) << told;
    EXPECT_EQ(kernel.received, bytes) << told;
    EXPECT_LE(spi.transfer_limit(), 1000U);
    const std::size_t before = kernel.transfers.size();
    EXPECT_TRUE(spi.write(bytes).ok());
    EXPECT_EQ(kernel.transfers.size() - before, (5'000U + spi.transfer_limit() - 1U) / spi.transfer_limit())
        << "the limit is found once";
  }
}

TEST(Spi, ADriverThatTakesNothingTeachesNoLimit) {
  Spidev kernel;
  SpiDevice spi("/dev/spidev0.0", {}, kernel);
  kernel.bufsiz = 0;
  EXPECT_EQ(spi.write(counting(5'000)), Status(Error::bus, Part::bus));
  EXPECT_EQ(spi.transfer_limit(), 4096U);
}

TEST(Spi, ShortTransfersAreGoneOnWith) {
  Spidev kernel;
  kernel.most_at_once = 37;
  SpiDevice spi("/dev/spidev0.0", {}, kernel);
  const Bytes bytes = counting(500);
  EXPECT_TRUE(spi.write(bytes).ok());
  EXPECT_EQ(kernel.received, bytes);
}

TEST(Spi, ATransferThatMovesNothingIsAFault) {
  Spidev kernel;
  kernel.most_at_once = 0;
  SpiDevice spi("/dev/spidev0.0", {}, kernel);
  EXPECT_EQ(spi.write(counting(5)), Status(Error::bus, Part::bus));
}

TEST(Spi, FaultsNameTheDevice) {
  Spidev kernel;
  SpiDevice spi("/dev/spidev0.0", {}, kernel);
  kernel.errors_at = 2;
  kernel.error = ESHUTDOWN;
  EXPECT_EQ(spi.write(counting(9'000)), Status(Error::disconnected, Part::bus));
  EXPECT_EQ(kernel.received.size(), 4096U) << "it went on after a fault";
  EXPECT_THAT(spi.fault(), AllOf(HasSubstr("SPI device /dev/spidev0.0"), HasSubstr("the device is gone")));
  kernel.errors_at = 1;
  kernel.error = ETIMEDOUT;
  EXPECT_EQ(spi.write(counting(5)), Status(Error::timeout, Part::bus));
  kernel.errors_at = 1;
  kernel.error = EINTR;
  EXPECT_TRUE(spi.write(counting(5)).ok()) << "a signal is no fault";
}

TEST(Spi, WhatCanNotBeSetUpIsSaid) {
  const auto open_with = [](int error) {
    Spidev kernel;
    kernel.open_error = error;
    return refusal([&] { SpiDevice("/dev/spidev9.9", {}, kernel); });
  };
  EXPECT_THAT(open_with(EACCES), HasSubstr("SPI device /dev/spidev9.9: permission denied; "));
  EXPECT_THAT(open_with(ENOENT), HasSubstr("/dev/spidev9.9: there is no such device"));
  EXPECT_THAT(open_with(EBUSY), HasSubstr("is using it"));
  Spidev kernel;
  kernel.refused = SPI_IOC_WR_MAX_SPEED_HZ;
  EXPECT_THAT(refusal([&] { SpiDevice("/dev/spidev0.0", {}, kernel); }),
              HasSubstr("10000000 Hz can't be set"));
  kernel.refused = SPI_IOC_WR_MODE;
  kernel.refused_error = ENOTTY;
  EXPECT_THAT(refusal([&] { SpiDevice("/dev/null", {}, kernel); }), HasSubstr("/dev/null is no SPI device"));
}

/// i2c-dev over an adapter with the limits it is given.
class I2cDev final : public OneDevice {
 public:
  int ioctl(int, unsigned long request, void* argument) override {
    if (request == I2C_FUNCS) {
      if (functions_error != 0) return fail(functions_error);
      *static_cast<unsigned long*>(argument) = functions;
      return 0;
    }
    if (signals > 0 && signals-- > 0) return fail(EINTR);
    if (error != 0) return fail(error);
    if (request == I2C_RDWR) {
      const auto& call = *static_cast<i2c_rdwr_ioctl_data*>(argument);
      EXPECT_EQ(call.nmsgs, 1U);
      EXPECT_EQ(call.msgs[0].addr, slave);
      if (call.msgs[0].len > longest) return fail(EOPNOTSUPP);
      messages.emplace_back(call.msgs[0].buf, call.msgs[0].buf + call.msgs[0].len);
      return 0;
    }
    const auto& call = *static_cast<i2c_smbus_ioctl_data*>(argument);
    EXPECT_EQ(request, static_cast<unsigned long>(I2C_SMBUS));
    Bytes message{call.command};
    if (call.size == I2C_SMBUS_BYTE) {
      // The command is all.
    } else if (call.size == I2C_SMBUS_BYTE_DATA) {
      message.push_back(call.data->byte);
    } else {
      EXPECT_LE(call.data->block[0], I2C_SMBUS_BLOCK_MAX);
      message.insert(message.end(), call.data->block + 1, call.data->block + 1 + call.data->block[0]);
    }
    messages.push_back(message);
    return 0;
  }
  int ioctl_number(int, unsigned long request, unsigned long number) override {
    EXPECT_EQ(request, static_cast<unsigned long>(I2C_SLAVE));
    if (slave_error != 0) return fail(slave_error);
    slave = number;
    return 0;
  }

  /// All transactions begin with the prefix and together carry these bytes.
  void expect_carried(std::uint8_t prefix, const Bytes& bytes) const {
    Bytes carried;
    for (const Bytes& message : messages) {
      EXPECT_EQ(message.at(0), prefix);
      carried.insert(carried.end(), message.begin() + 1, message.end());
    }
    EXPECT_EQ(carried, bytes);
  }

  unsigned long functions = I2C_FUNC_I2C;
  std::size_t longest = 8192;
  int functions_error = 0;
  int slave_error = 0;
  int error = 0;
  int signals = 0;  ///< Transfers that end early for one.
  unsigned long slave = 0;
  std::vector<Bytes> messages;
};

constexpr std::uint8_t memory = 0x40;

TEST(I2c, AWriteIsOneTransactionWherePossible) {
  I2cDev kernel;
  I2cDevice i2c("/dev/i2c-1", kernel);
  const Bytes bytes = counting(1024);
  EXPECT_TRUE(i2c.write(0x3D, {&memory, 1}, bytes).ok());
  EXPECT_EQ(kernel.slave, 0x3DU);
  ASSERT_EQ(kernel.messages.size(), 1U);
  kernel.expect_carried(memory, bytes);
}

TEST(I2c, AdaptersWithLimitsGetSeveralWithThePrefixBeforeEach) {
  for (const std::size_t longest : {2U, 3U, 16U, 32U, 255U, 8192U}) {
    I2cDev kernel;
    kernel.longest = longest;
    I2cDevice i2c("/dev/i2c-1", kernel);
    const Bytes bytes = counting(20'000);
    EXPECT_TRUE(i2c.write(0x3C, {&memory, 1}, bytes).ok()) << longest;
    kernel.expect_carried(memory, bytes);
  }
}

TEST(I2c, AdaptersThatKnowSmbusAloneGetBlocksOrBytes) {
  constexpr unsigned long bytes_alone = I2C_FUNC_SMBUS_WRITE_BYTE_DATA;
  constexpr unsigned long blocks_too =
      bytes_alone | static_cast<unsigned long>(I2C_FUNC_SMBUS_WRITE_I2C_BLOCK);
  for (const unsigned long functions : {blocks_too, bytes_alone}) {
    I2cDev kernel;
    kernel.functions = functions;
    I2cDevice i2c("/dev/i2c-1", kernel);
    const Bytes bytes = counting(100);
    EXPECT_TRUE(i2c.write(0x3C, {&memory, 1}, bytes).ok());
    kernel.expect_carried(memory, bytes);
    EXPECT_EQ(kernel.messages.size(), functions == bytes_alone ? 100U : 4U);
  }
  I2cDev kernel;
  kernel.functions = 0;
  EXPECT_THAT(refusal([&] { I2cDevice("/dev/i2c-1", kernel); }), HasSubstr("I2C bus /dev/i2c-1"));
}

TEST(I2c, APrefixAloneIsATransactionToo) {
  for (const unsigned long functions :
       {static_cast<unsigned long>(I2C_FUNC_I2C), static_cast<unsigned long>(I2C_FUNC_SMBUS_WRITE_I2C_BLOCK),
        static_cast<unsigned long>(I2C_FUNC_SMBUS_WRITE_BYTE_DATA)}) {
    I2cDev kernel;
    kernel.functions = functions;
    I2cDevice i2c("/dev/i2c-1", kernel);
    kernel.signals = 2;
    EXPECT_TRUE(i2c.write(0x3C, {&memory, 1}, {}).ok());
    EXPECT_THAT(kernel.messages, ElementsAre(Bytes{memory})) << "once, signals or not";
  }
}

TEST(I2c, AnAdapterThatTakesNothingTeachesNoLimit) {
  I2cDev kernel;
  I2cDevice i2c("/dev/i2c-1", kernel);
  const Bytes bytes = counting(1'000);
  kernel.error = EINVAL;
  EXPECT_FALSE(i2c.write(0x3C, {&memory, 1}, bytes).ok());
  kernel.error = 0;
  EXPECT_TRUE(i2c.write(0x3C, {&memory, 1}, bytes).ok());
  EXPECT_EQ(kernel.messages.size(), 1U);
}

TEST(I2c, FaultsNameBusAndAddress) {
  I2cDev kernel;
  I2cDevice i2c("/dev/i2c-1", kernel);
  const Bytes bytes = counting(10);
  const auto fails_with = [&](int error) {
    kernel.error = error;
    return i2c.write(0x3C, {&memory, 1}, bytes);
  };
  EXPECT_EQ(fails_with(ENXIO), Status(Error::bus, Part::bus));
  EXPECT_THAT(i2c.fault(),
              AllOf(HasSubstr("I2C bus /dev/i2c-1, address 0x3c"), HasSubstr("nothing answers")));
  EXPECT_EQ(fails_with(EREMOTEIO), Status(Error::bus, Part::bus));
  EXPECT_EQ(fails_with(ETIMEDOUT), Status(Error::timeout, Part::bus));
  EXPECT_EQ(fails_with(ENODEV), Status(Error::disconnected, Part::bus));
  EXPECT_THAT(i2c.fault(), HasSubstr("the device is gone"));
  EXPECT_EQ(fails_with(EOPNOTSUPP), Status(Error::bus, Part::bus)) << "an adapter that takes nothing";
  kernel.error = 0;
  kernel.slave_error = EBUSY;
  EXPECT_EQ(i2c.write(0x3D, {&memory, 1}, bytes), Status(Error::bus, Part::bus));
  EXPECT_THAT(i2c.fault(), AllOf(HasSubstr("0x3d"), HasSubstr("a driver of the kernel is using it")));
}

TEST(I2c, WhatCanNotBeSetUpIsSaid) {
  I2cDev kernel;
  kernel.open_error = EACCES;
  EXPECT_THAT(refusal([&] { I2cDevice("/dev/i2c-9", kernel); }),
              HasSubstr("I2C bus /dev/i2c-9: permission denied; "));
  kernel.open_error = 0;
  kernel.functions_error = ENOTTY;
  EXPECT_THAT(refusal([&] { I2cDevice("/dev/null", kernel); }), HasSubstr("/dev/null is no I2C bus"));
}

TEST(MonotonicClock, WaitsAtLeastAsLongAsAsked) {
  hal::linux_io::MonotonicClock clock;
  const hal::Nanoseconds until = clock.now() + 2'000'000;
  clock.wait_until(until);
  EXPECT_GE(clock.now(), until);
  clock.wait_until(0);
}

}  // namespace
