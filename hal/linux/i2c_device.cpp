// SPDX-License-Identifier: MIT
#include <hal/linux/i2c_device.hpp>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <linux/i2c-dev.h>
#include <linux/i2c.h>
#include <new>

namespace hal::linux_io {

namespace {

/// The kernel's own limit of a message.
constexpr std::size_t longest_message = 8192;
constexpr std::size_t least_message = 2;

bool too_long(int error) { return error == EMSGSIZE || error == EOPNOTSUPP || error == EINVAL; }

}  // namespace

I2cDevice::I2cDevice(const std::string& path, System& system) : file_(system, "I2C bus", path) {
  unsigned long functions = 0;
  if (file_.control(I2C_FUNCS, functions) < 0) file_.refuse("its adapter can't be asked", errno);
  if ((functions & I2C_FUNC_I2C) != 0) {
    way_ = Way::messages;
    limit_ = longest_message;
  } else if ((functions & I2C_FUNC_SMBUS_WRITE_I2C_BLOCK) != 0) {
    way_ = Way::blocks;
    limit_ = I2C_SMBUS_BLOCK_MAX + 1U;
  } else if ((functions & I2C_FUNC_SMBUS_WRITE_BYTE_DATA) != 0) {
    way_ = Way::bytes;
    limit_ = 2;
  } else {
    throw DeviceError(file_.name() +
                      ": its adapter can't write to displays (no I2C messages, no SMBus blocks or bytes)");
  }
}

Status I2cDevice::fail(std::uint8_t address, int error) {
  char place[8];
  std::snprintf(place, sizeof place, "0x%02x", static_cast<unsigned>(address));
  const std::string start = file_.name() + ", address " + place + ": ";
  const Status status =
      error == ENXIO || error == EREMOTEIO ? Status{Error::bus, Part::bus} : status_of(error, Part::bus);
  if (error == ENXIO || error == EREMOTEIO) {
    fault_ = start + "nothing answers; are wiring and address right (i2cdetect shows who answers)?";
  } else if (error == EBUSY) {
    fault_ = start + "a driver of the kernel is using it";
  } else if (status.error() == Error::disconnected) {
    fault_ = start + "the device is gone";
  } else {
    fault_ = start + "a transfer failed: " + error_text(error);
  }
  return status;
}

int I2cDevice::send_smbus(std::span<const std::uint8_t> prefix, std::span<const std::uint8_t> bytes) {
  i2c_smbus_data data{};
  i2c_smbus_ioctl_data call{};
  call.read_write = I2C_SMBUS_WRITE;
  call.command = prefix[0];
  call.data = &data;
  if (bytes.empty()) {
    call.size = I2C_SMBUS_BYTE;
  } else if (way_ == Way::blocks) {
    call.size = I2C_SMBUS_I2C_BLOCK_DATA;
    data.block[0] = static_cast<std::uint8_t>(bytes.size());
    std::copy(bytes.begin(), bytes.end(), data.block + 1);
  } else {
    call.size = I2C_SMBUS_BYTE_DATA;
    data.byte = bytes[0];
  }
  return file_.control(I2C_SMBUS, call) < 0 ? errno : 0;
}

int I2cDevice::send(std::uint8_t address, std::span<const std::uint8_t> prefix,
                    std::span<const std::uint8_t> bytes) {
  if (address_ != address) {
    // The kernel refuses an address that one of its drivers uses.
    if (file_.system().ioctl_number(file_.number(), I2C_SLAVE, address) < 0) return errno;
    address_ = address;
  }
  if (way_ != Way::messages) return send_smbus(prefix, bytes);
  message_.assign(prefix.begin(), prefix.end());
  message_.insert(message_.end(), bytes.begin(), bytes.end());
  i2c_msg message{};
  message.addr = address;
  message.len = static_cast<std::uint16_t>(message_.size());
  message.buf = message_.data();
  i2c_rdwr_ioctl_data call{};
  call.msgs = &message;
  call.nmsgs = 1;
  return file_.control(I2C_RDWR, call) < 0 ? errno : 0;
}

Status I2cDevice::do_write(std::uint8_t address, std::span<const std::uint8_t> prefix,
                           std::span<const std::uint8_t> bytes) noexcept {
  try {
    // An SMBus write needs its command byte.
    if (prefix.size() >= limit_ || (way_ != Way::messages && prefix.size() != 1U))
      return fail(address, EOPNOTSUPP);
    const std::size_t limit_before = limit_;
    for (;;) {
      const std::size_t size = std::min(bytes.size(), limit_ - prefix.size());
      const int error = send(address, prefix, bytes.first(size));
      if (error == 0) {
        bytes = bytes.subspan(size);
        if (bytes.empty()) return {};
      } else if (way_ == Way::messages && too_long(error) && size > 1U && limit_ > least_message) {
        limit_ = std::max((prefix.size() + size) / 2U, prefix.size() + 1U);
      } else {
        // If the length wasn't to blame, nothing was learned.
        limit_ = limit_before;
        return fail(address, error);
      }
    }
  } catch (const std::bad_alloc&) {
    return {Error::bus, Part::bus};
  }
}

}  // namespace hal::linux_io
