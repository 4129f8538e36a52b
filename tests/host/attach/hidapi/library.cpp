// SPDX-License-Identifier: MIT
//
// The functions of hidapi that are used. The library has the name of the real one, so whoever loads that by
// its name gets this.
#include "fake_hidapi.hpp"

#include <climits>

#include <algorithm>
#include <cstring>
#include <hidapi/hidapi.h>
#include <iterator>
#include <utility>

struct hid_device_ {
  std::string path;
};

namespace fake_hidapi {

namespace {

Bus& the_bus() {
  static Bus bus;
  return bus;
}

/// Null once it is unplugged.
const Device* find(const std::string& path) {
  const auto& all = the_bus().devices;
  const auto found = std::find_if(all.begin(), all.end(), [&](const Device& d) { return d.path == path; });
  return found == all.end() ? nullptr : &*found;
}

char* copy(const std::string& text) {
  auto* const bytes = new char[text.size() + 1];
  std::strcpy(bytes, text.c_str());
  return bytes;
}
wchar_t* copy(const std::wstring& text) {
  auto* const bytes = new wchar_t[text.size() + 1];
  std::copy(text.c_str(), text.c_str() + text.size() + 1, bytes);
  return bytes;
}

}  // namespace

Bus& bus() { return the_bus(); }
void reset() { the_bus() = {}; }

void Bus::unplug(const std::string& path) {
  std::erase_if(devices, [&](const Device& d) { return d.path == path; });
  writes_left = INT_MAX;
}

}  // namespace fake_hidapi

using fake_hidapi::bus;

extern "C" {

int hid_init() { return 0; }
int hid_exit() { return 0; }

hid_device_info* hid_enumerate(unsigned short, unsigned short) {
  bus().on_look();
  hid_device_info* list = nullptr;
  for (auto d = bus().devices.rbegin(); d != bus().devices.rend(); ++d) {
    auto* const info = new hid_device_info{};
    // One without a file, yet.
    info->path = d->path.empty() ? nullptr : fake_hidapi::copy(d->path);
    info->vendor_id = d->vendor;
    info->product_id = d->product_number;
    info->serial_number = fake_hidapi::copy(d->serial);
    info->product_string = fake_hidapi::copy(d->product);
    info->usage_page = d->usage_page;
    info->usage = d->usage;
    info->next = list;
    list = info;
  }
  return list;
}

void hid_free_enumeration(hid_device_info* list) {
  while (list != nullptr) {
    delete[] list->path;
    delete[] list->serial_number;
    delete[] list->product_string;
    delete std::exchange(list, list->next);
  }
}

hid_device* hid_open_path(const char* path) {
  const auto* const device = fake_hidapi::find(path);
  if (device == nullptr || device->locked) return nullptr;
  ++bus().open;
  return new hid_device_{path};
}

int hid_write(hid_device* device, const unsigned char* data, size_t length) {
  const auto* const d = fake_hidapi::find(device->path);
  if (d == nullptr) return -1;
  if (bus().writes_left-- == 0) {
    bus().unplug(device->path);
    return -1;
  }
  std::span<const std::uint8_t> report(data, length);
  if (!d->numbered) report = report.subspan(1);
  return d->model->send(report).ok() ? static_cast<int>(length) : -1;
}

int hid_read_timeout(hid_device* device, unsigned char* data, size_t length, int milliseconds) {
  const auto* const d = fake_hidapi::find(device->path);
  if (d == nullptr) return -1;
  const auto patience = static_cast<hal::Nanoseconds>(std::max(milliseconds, 0)) * 1'000'000U;
  const hal::hid::Received got = d->model->receive({data, length}, patience);
  if (got.status.ok()) return static_cast<int>(got.size);
  return got.status.error() == hal::Error::timeout ? 0 : -1;
}

int hid_send_feature_report(hid_device*, const unsigned char*, size_t) { return -1; }

void hid_close(hid_device* device) {
  --bus().open;
  delete device;
}

const wchar_t* hid_error(hid_device*) { return L"permission denied"; }

}  // extern "C"
