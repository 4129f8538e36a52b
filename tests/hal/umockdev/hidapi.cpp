// SPDX-License-Identifier: MIT
//
// hidapi over hidraw against a device that umockdev makes up in this process: sysfs, the file in /dev, and
// what its reads, writes and ioctls do. Behind the file is the device side of the report protocol.
#include <hal/hid/device/device.hpp>
#include <hal/hid/host/hidapi.hpp>
#include <hal/hid/host/panel.hpp>
#include <hal/sim/panel.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <linux/hidraw.h>
#include <mutex>
#include <string>
#include <string_view>
#include <sys/ioctl.h>
#include <umockdev.h>
#include <unistd.h>
#include <vector>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define INTAGLIO_NO_PRELOAD
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(memory_sanitizer) || __has_feature(thread_sanitizer)
#define INTAGLIO_NO_PRELOAD
#endif
#endif

namespace {

using hal::hid::HidApi;
using Bytes = std::vector<std::uint8_t>;

constexpr const char* sysfs =
    "P: /devices/virt/usb1/1-1\nE: DEVTYPE=usb_device\nE: SUBSYSTEM=usb\nA: idVendor=1209\\n\n"
    "A: idProduct=0002\\n\nA: manufacturer=Intaglio\nA: product=Intaglio display\nA: bcdDevice=0100\\n\n\n"
    "P: /devices/virt/usb1/1-1/1-1:1.0\nE: DEVTYPE=usb_interface\nE: SUBSYSTEM=usb\nA: "
    "bInterfaceNumber=00\\n\n\n"
    "P: /devices/virt/usb1/1-1/1-1:1.0/0003:1209:0002.0001\nE: SUBSYSTEM=hid\n"
    "E: HID_ID=0003:00001209:00000002\nE: HID_NAME=Intaglio display\nE: HID_UNIQ=S1\nE: HID_PHYS=x\n"
    "A: uevent=HID_ID=0003:00001209:00000002\\nHID_NAME=Intaglio display\\nHID_UNIQ=S1\\n\n\n"
    "P: /devices/virt/usb1/1-1/1-1:1.0/0003:1209:0002.0001/hidraw/hidraw0\nN: hidraw0\nE: SUBSYSTEM=hidraw\n"
    "E: DEVNAME=/dev/hidraw0\nE: MAJOR=240\nE: MINOR=0\nL: device=../..\nA: dev=240:0\\n\n";

/// All of it, with the report descriptor, whose usage tells what the device is.
std::string description() {
  constexpr std::string_view digits = "0123456789ABCDEF";
  std::string hex;
  for (const std::uint8_t byte : hal::hid::report_descriptor(64)) {
    hex += digits[byte >> 4U];
    hex += digits[byte & 15U];
  }
  std::string text = sysfs;
  const std::string before = "E: HID_PHYS=x\n";
  return text.insert(text.find(before) + before.size(), "H: report_descriptor=" + hex + '\n');
}

/// What is behind /dev/hidraw0. umockdev calls it from a thread of its own.
class Gadget {
 public:
  Gadget() : glass(hal::sim::paletted(24, 16, 8), clock), device(glass, nullptr, {}) {}

  std::mutex mutex;
  hal::sim::VirtualClock clock;
  hal::sim::Panel glass;
  hal::hid::Device device;
  bool gone = false;

  void attach(UMockdevTestbed* testbed) {
    UMockdevIoctlBase* const handler = umockdev_ioctl_base_new();
    g_signal_connect(handler, "handle-ioctl", G_CALLBACK(on_ioctl), this);
    g_signal_connect(handler, "handle-write", G_CALLBACK(on_write), this);
    g_signal_connect(handler, "handle-read", G_CALLBACK(on_read), this);
    GError* error = nullptr;
    ASSERT_TRUE(umockdev_testbed_attach_ioctl(testbed, "/dev/hidraw0", handler, &error)) << error->message;
    g_object_unref(handler);
    // The file is a terminal underneath; a line that no one reads makes it look readable for ever.
    const int terminal = umockdev_testbed_get_dev_fd(testbed, "/dev/hidraw0");
    ASSERT_EQ(write(terminal, "\n", 1), 1);
  }

 private:
  static gboolean on_ioctl(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer) {
    constexpr auto descriptor = hal::hid::report_descriptor(64);
    UMockdevIoctlData* const argument = umockdev_ioctl_client_get_arg(client);
    const gulong request = umockdev_ioctl_client_get_request(client);
    const auto answer = [&](void* bytes, int size) {
      UMockdevIoctlData* const d =
          umockdev_ioctl_data_resolve(argument, 0, static_cast<gsize>(size), nullptr);
      umockdev_ioctl_data_update(d, 0, static_cast<guint8*>(bytes), size);
      umockdev_ioctl_client_complete(client, 0, 0);
      return TRUE;
    };
    if (request == HIDIOCGRDESCSIZE) {
      int size = descriptor.size();
      return answer(&size, sizeof size);
    }
    if (request == HIDIOCGRDESC) {
      hidraw_report_descriptor d{};
      d.size = descriptor.size();
      std::copy(descriptor.begin(), descriptor.end(), d.value);
      return answer(&d, sizeof d);
    }
    return FALSE;
  }
  static gboolean on_write(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer self) {
    auto& gadget = *static_cast<Gadget*>(self);
    const std::lock_guard lock(gadget.mutex);
    UMockdevIoctlData* const bytes = umockdev_ioctl_client_get_arg(client);
    if (gadget.gone) {
      umockdev_ioctl_client_complete(client, -1, ENODEV);
      return TRUE;
    }
    // The kernel takes the number of the report off, which is 0.
    EXPECT_EQ(bytes->data[0], 0);
    gadget.pass(1'000'000);
    gadget.device.receive({bytes->data + 1, static_cast<std::size_t>(bytes->data_len - 1)});
    umockdev_ioctl_client_complete(client, bytes->data_len, 0);
    return TRUE;
  }
  static gboolean on_read(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer self) {
    auto& gadget = *static_cast<Gadget*>(self);
    const std::lock_guard lock(gadget.mutex);
    UMockdevIoctlData* const bytes = umockdev_ioctl_client_get_arg(client);
    if (gadget.gone) {
      umockdev_ioctl_client_complete(client, -1, EIO);
      return TRUE;
    }
    gadget.pass(1'000'000);
    Bytes report(64);
    const auto size = static_cast<int>(gadget.device.next(report));
    if (size != 0) umockdev_ioctl_data_update(bytes, 0, report.data(), size);
    umockdev_ioctl_client_complete(client, size, 0);
    return TRUE;
  }
  void pass(hal::Nanoseconds time) {
    clock.advance(time);
    device.poll();
    while (!device.ready()) {
      clock.advance(time);
      device.poll();
    }
  }
};

/// The clock of the desk.
class Desk final : public hal::Clock {
 private:
  hal::Nanoseconds do_now() noexcept override {
    return static_cast<hal::Nanoseconds>(std::chrono::steady_clock::now().time_since_epoch().count());
  }
  void do_wait_until(hal::Nanoseconds) noexcept override {}
};

class HidApiOverHidraw : public testing::Test {
 protected:
  void SetUp() override {
    if (std::getenv("INTAGLIO_PRELOADED") == nullptr) GTEST_SKIP() << "not under libumockdev-preload";
    testbed_ = umockdev_testbed_new();
    GError* error = nullptr;
    ASSERT_TRUE(umockdev_testbed_add_from_string(testbed_, description().c_str(), &error)) << error->message;
    gadget_.attach(testbed_);
  }
  void TearDown() override {
    if (testbed_ != nullptr) g_object_unref(testbed_);
  }

  UMockdevTestbed* testbed_ = nullptr;
  Gadget gadget_;
};

TEST_F(HidApiOverHidraw, FindsTheDeviceByItsUsage) {
  const auto devices =
      HidApi::over(HidApi::Way::hidraw).devices(hal::hid::test_vendor, hal::hid::test_product);
  ASSERT_EQ(devices.size(), 1U);
  EXPECT_EQ(devices[0].path, "/dev/hidraw0");
  EXPECT_EQ(devices[0].serial, "S1");
  EXPECT_EQ(devices[0].product, "Intaglio display");
  EXPECT_EQ(devices[0].usage_page, hal::hid::usage_page);
  EXPECT_EQ(devices[0].usage, hal::hid::usage);
  EXPECT_TRUE(HidApi::over(HidApi::Way::hidraw).devices(hal::hid::test_vendor, 7).empty());
}

TEST_F(HidApiOverHidraw, ShowsFramesAndSaysWhenTheDeviceIsGone) {
  const HidApi& api = HidApi::over(HidApi::Way::hidraw);
  const auto devices = api.devices();
  ASSERT_EQ(devices.size(), 1U);
  hal::hid::HidApiPort port(api, devices[0], hal::hid::Numbering::none);
  Desk clock;
  hal::hid::Link link(port, clock);
  ASSERT_TRUE(link.open().ok()) << port.fault();
  hal::hid::HidPanel panel(link);
  for (int n = 0; n < 20; ++n) {
    const auto buffer = panel.buffer(n % 2);
    for (std::size_t i = 0; i < buffer.size(); ++i)
      buffer[i] = static_cast<std::uint8_t>(static_cast<std::size_t>(n) * i / 7U);
    ASSERT_TRUE(panel.show(n % 2, {}).ok()) << port.fault();
    while (panel.show_pending()) ASSERT_TRUE(panel.wait_for_vblank().ok());
    const std::lock_guard lock(gadget_.mutex);
    ASSERT_EQ(gadget_.glass.displayed().indices, Bytes(buffer.begin(), buffer.end()));
  }
  {
    const std::lock_guard lock(gadget_.mutex);
    gadget_.gone = true;
  }
  EXPECT_EQ(panel.show(0, {}).error(), hal::Error::disconnected);
  EXPECT_NE(port.fault().find("1209:0002 (Intaglio display) at /dev/hidraw0 was unplugged"),
            std::string::npos)
      << port.fault();
  // Back again, restarted: the same serial number.
  {
    const std::lock_guard lock(gadget_.mutex);
    gadget_.gone = false;
    gadget_.device.unplugged();
  }
  EXPECT_TRUE(panel.show(1, {}).ok()) << port.fault();
  EXPECT_EQ(panel.counters().reconnects, 1U);
}

TEST_F(HidApiOverHidraw, WaitsItsTimeThroughEmptyReads) {
  const HidApi& api = HidApi::over(HidApi::Way::hidraw);
  hal::hid::HidApiPort port(api, api.devices().at(0), hal::hid::Numbering::none);
  Bytes report(64);
  const auto begin = std::chrono::steady_clock::now();
  // The device has nothing to say: every read is empty.
  EXPECT_EQ(port.receive(report, 20'000'000).status.error(), hal::Error::timeout);
  EXPECT_GE(std::chrono::steady_clock::now() - begin, std::chrono::milliseconds(20));
}

TEST_F(HidApiOverHidraw, NamesTheDeviceThatItCannotOpen) {
  const HidApi& api = HidApi::over(HidApi::Way::hidraw);
  hal::hid::HidDevice device = api.devices().at(0);
  device.path = "/dev/hidraw7";
  try {
    const hal::hid::HidApiPort port(api, device, hal::hid::Numbering::none);
    FAIL() << "a device that isn't there was opened";
  } catch (const hal::hid::HidError& error) {
    EXPECT_NE(std::string(error.what()).find("1209:0002"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("/dev/hidraw7"), std::string::npos) << error.what();
  }
}

}  // namespace

int main(int count, char** arguments) {
#ifndef INTAGLIO_NO_PRELOAD
  // umockdev stands between a program and the C library, so it must be there from the start.
  if (std::getenv("INTAGLIO_PRELOADED") == nullptr) {
    setenv("INTAGLIO_PRELOADED", "1", 1);
    setenv("LD_PRELOAD", "libumockdev-preload.so.0", 1);
    execv("/proc/self/exe", arguments);
  }
#endif
  testing::InitGoogleTest(&count, arguments);
  return RUN_ALL_TESTS();
}
