// SPDX-License-Identifier: MIT
//
// Displays on USB HID:
//
//     hid:intaglio[:SERIAL]          a display of the project's report protocol
//     hid:g13, hid:g15v2, hid:g510   the display of a keyboard
//     hid:mcp2221/CONTROLLER@3c      a display on I2C behind an MCP2221A, ssd1306 for one
//
// with `libusb/` or `hidraw/` (the default) in front: hid:libusb/g13.
#include <hal/hid/host/gaming_lcd.hpp>
#include <hal/hid/host/hidapi.hpp>
#include <hal/hid/host/mcp2221.hpp>
#include <hal/hid/host/panel.hpp>
#include <hal/hid/host/replug_panel.hpp>
#include <hal/linux/monotonic_clock.hpp>
#include <hal/panels/expanded_panel.hpp>
#include <hal/panels/modules.hpp>
#include <host/attach/backend.hpp>
#include <host/failure.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <string_view>
#include <utility>

namespace host {

namespace {

using hal::hid::HidApi;
using hal::hid::HidApiPort;
using hal::hid::HidDevice;
using hal::hid::Numbering;

/// How long a program waits for a display that was unplugged.
constexpr hal::Nanoseconds replug_patience = 5'000'000'000;

constexpr std::string_view forms =
    "hid:intaglio, hid:intaglio:SERIAL, hid:g13, hid:g15v2, hid:g510, or hid:mcp2221/ssd1306@3c; libusb/ in "
    "front uses that: hid:libusb/g13";

/// What follows `hid:`, taken apart.
struct Name {
  HidApi::Way way = HidApi::Way::hidraw;
  std::string kind;
  std::string serial;
};

Name name_of(const AttachOptions& options) {
  std::string text = device_of(options);
  Name name;
  for (const auto& [prefix, way] :
       {std::pair{"libusb/", HidApi::Way::libusb}, {"hidraw/", HidApi::Way::hidraw}})
    if (text.starts_with(prefix)) {
      name.way = way;
      text.erase(0, std::string_view(prefix).size());
      break;
    }
  const std::size_t colon = text.find(':');
  name.kind = text.substr(0, colon);
  if (colon != std::string::npos) name.serial = text.substr(colon + 1U);
  return name;
}

bool is_ours(const HidDevice& d) {
  if (d.usage_page != 0) return d.usage_page == hal::hid::usage_page && d.usage == hal::hid::usage;
  // libusb doesn't tell usages.
  return d.product.starts_with("Intaglio");
}

bool is_bridge(const HidDevice& d) {
  return d.vendor == hal::hid::microchip && d.product_number == hal::hid::mcp2221_product;
}

const hal::hid::LcdDevice* lcd_of(const HidDevice& d) {
  return d.vendor == hal::hid::logitech ? hal::hid::lcd_device(d.product_number) : nullptr;
}

/// The device that is meant. Of one with several interfaces the display is the one with a usage of its
/// maker's.
template <class Wanted>
HidDevice find(const HidApi& api, const AttachOptions& options, const Name& name, Wanted wanted) {
  std::optional<HidDevice> found;
  for (HidDevice& d : api.devices()) {
    if (!wanted(d) || (!name.serial.empty() && d.serial != name.serial)) continue;
    const bool own_usage = d.usage_page >= 0xFF00U;
    if (!found || own_usage) found = std::move(d);
    if (own_usage) break;
  }
  if (!found)
    throw Failure("no device for --panel " + options.panel + " is plugged in; --list-panels shows what is");
  return *found;
}

void refuse(const AttachOptions& o, std::initializer_list<std::pair<bool, const char*>> given) {
  for (const auto& [is, option] : given)
    if (is) throw Failure("--panel " + o.panel + " knows no " + option);
}

void refuse_settings(const AttachOptions& o) {
  refuse(o, {{o.rotate != 0, "--rotate"}, {o.invert, "--invert"}, {o.contrast.has_value(), "--contrast"}});
}

std::string size_of(const hal::Capabilities& c) {
  return std::to_string(c.width) + 'x' + std::to_string(c.height);
}

std::string reconnects_line(std::uint64_t count) { return "hid_reconnects " + std::to_string(count) + '\n'; }

/// What all have: a port, and words for what went wrong with it.
class HidAttached : public AttachedPanel {
 public:
  HidAttached(const HidApi& api, HidDevice device, Numbering numbering)
      : api_(&api), port_(api, std::move(device), numbering) {}
  std::string description() const override {
    return port_.description() + " over " + std::string(api_->name());
  }
  std::string fault() const override { return port_.fault(); }
  std::string notices() override { return port_.take_notices(); }
  bool keep() override { return kept_ = true; }

 protected:
  /// The panel as the program sees it: with --dither it draws 256 colours.
  hal::Panel& seen(hal::Panel& panel, const AttachOptions& options) {
    if (!options.dither) return panel;
    return expanded_.emplace(panel, expansion_);
  }

  hal::linux_io::MonotonicClock clock_;
  const HidApi* api_;
  HidApiPort port_;
  bool kept_ = false;

 private:
  std::array<std::uint8_t, 1024> expansion_{};
  std::optional<hal::panels::ExpandedPanel> expanded_;
};

class OwnDisplay final : public HidAttached {
 public:
  OwnDisplay(const HidApi& api, HidDevice device)
      : HidAttached(api, std::move(device), Numbering::none), link_(port_, clock_) {
    if (const hal::Status s = link_.open(); !s.ok())
      throw Failure(port_.description() + (s.error() == hal::Error::unsupported
                                               ? " speaks another version of the protocol"
                                           : port_.fault().empty() ? " doesn't answer"
                                                                   : ": " + port_.fault()));
    panel_.emplace(link_, hal::hid::HidPanelOptions{replug_patience});
    input_.emplace(link_);
  }
  ~OwnDisplay() override {
    if (kept_) return;
    const auto black = panel_->buffer(0);
    std::fill(black.begin(), black.end(), std::uint8_t{0});
    const std::vector<std::uint8_t> colours(static_cast<std::size_t>(panel_->capabilities().palette_entries) *
                                            3U);
    hal::hid::HidPanel& last = *panel_;
    if (last.connected()) last.show(0, colours).ignore();
  }
  hal::Panel& panel() override { return *panel_; }
  hal::Input* input() override { return link_.info().has_keys ? &*input_ : nullptr; }
  std::string description() const override {
    return size_of(panel_->capabilities()) + ", " + HidAttached::description();
  }
  std::string fault() const override {
    if (std::string text = HidAttached::fault(); !text.empty()) return text;
    return panel_->connected() ? port_.description() + " doesn't answer, or not as the protocol says"
                               : port_.description() + " is back, but not as the display that it was";
  }
  std::string counters() const override {
    const auto& l = link_.counters();
    const auto& p = panel_->counters();
    std::string text;
    for (const auto& [key, value] : {std::pair{"reports", l.sent},
                                     {"reports_again", l.resent},
                                     {"frames_whole", p.whole},
                                     {"frames_refused", p.rejected}})
      text += "hid_" + std::string(key) + ' ' + std::to_string(value) + '\n';
    return text + reconnects_line(p.reconnects);
  }

 private:
  hal::hid::Link link_;
  std::optional<hal::hid::HidPanel> panel_;
  std::optional<hal::hid::HidInput> input_;
};

class KeyboardDisplay final : public HidAttached {
 public:
  KeyboardDisplay(const HidApi& api, HidDevice device, const hal::hid::LcdDevice& kind,
                  const AttachOptions& options)
      : HidAttached(api, std::move(device), Numbering::numbered),
        panel_(port_, &clock_, options.refresh_millihertz == 0 ? 30'000U : options.refresh_millihertz),
        plugged_(
            panel_, port_, clock_, [this] { return panel_.start(); }, replug_patience),
        input_(port_, kind),
        seen_(seen(plugged_, options)) {
    if (!panel_.start().ok()) throw Failure(port_.fault());
  }
  ~KeyboardDisplay() override {
    if (!kept_) panel_.stop().ignore();
  }
  hal::Panel& panel() override { return seen_; }
  hal::Input* input() override { return &input_; }
  std::string counters() const override { return reconnects_line(plugged_.reconnects()); }

 private:
  hal::hid::GamingLcd panel_;
  hal::hid::ReplugPanel plugged_;
  hal::hid::LcdInput input_;
  hal::Panel& seen_;
};

class BridgedDisplay final : public HidAttached {
 public:
  BridgedDisplay(const HidApi& api, HidDevice device, const hal::panels::Module& module, std::uint8_t address,
                 const AttachOptions& options)
      : HidAttached(api, std::move(device), Numbering::none),
        bus_(port_, clock_),
        commands_(bus_, address, module.i2c_framing),
        driver_(module.make(storage_, parts(options))),
        plugged_(
            driver_, port_, clock_, [this] { return start(); }, replug_patience),
        seen_(seen(plugged_, options)) {
    if (!bus_.start().ok()) throw Failure(port_.description() + " doesn't answer");
    if (!driver_.start().ok()) throw Failure(fault());
  }
  ~BridgedDisplay() override {
    if (!kept_) driver_.stop().ignore();
  }
  hal::Panel& panel() override { return seen_; }
  std::string fault() const override {
    std::string text = HidAttached::fault();
    return text.empty() ? "nothing answers at that address of the I2C bus behind " + port_.description()
                        : text;
  }
  std::string counters() const override { return reconnects_line(plugged_.reconnects()); }

 private:
  hal::Status start() {
    const hal::Status s = bus_.start();
    return s.ok() ? driver_.start() : s;
  }
  hal::panels::ModuleParts parts(const AttachOptions& options) {
    hal::panels::ModuleParts parts{&commands_, &clock_, nullptr, {}};
    parts.options.rotation = static_cast<hal::panels::Rotation>(options.rotate / 90);
    parts.options.negative = options.invert;
    if (options.contrast) parts.options.contrast = static_cast<std::uint8_t>(*options.contrast);
    parts.options.refresh_millihertz = options.refresh_millihertz;
    return parts;
  }

  hal::hid::Mcp2221I2c bus_;
  hal::panels::I2cPort commands_;
  hal::panels::ModuleStorage storage_;
  hal::panels::BusPanel& driver_;
  hal::hid::ReplugPanel plugged_;
  hal::Panel& seen_;
};

std::unique_ptr<AttachedPanel> attach_bridged(const AttachOptions& options, const Name& name,
                                              std::string_view display) {
  const std::size_t at = display.find('@');
  const std::string_view controller = display.substr(0, at);
  unsigned address = 0x3C;
  if (at != std::string_view::npos) {
    const std::string_view text = display.substr(at + 1U);
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), address, 16);
    if (error != std::errc{} || end != text.data() + text.size() || address < 0x03 || address > 0x77)
      throw Failure("'" + std::string(text) + "' is no I2C address: two hexadecimal digits, 03 to 77");
  }
  const hal::panels::Module* const module = hal::panels::find_module(controller);
  if (module == nullptr || !module->i2c) {
    std::string names;
    for (const hal::panels::Module& m : hal::panels::modules())
      if (m.i2c) names += (names.empty() ? "" : ", ") + std::string(m.name);
    throw Failure("no display '" + std::string(controller) +
                  "' can be had behind an MCP2221A; these can: " + names);
  }
  if (at == std::string_view::npos) address = module->i2c_address;
  const HidApi& api = HidApi::over(name.way);
  return std::make_unique<BridgedDisplay>(api, find(api, options, name, is_bridge), *module,
                                          static_cast<std::uint8_t>(address), options);
}

}  // namespace

std::unique_ptr<AttachedPanel> attach_hid(const AttachOptions& options) {
  const Name name = name_of(options);
  constexpr std::string_view bridge = "mcp2221/";
  if (name.kind.starts_with(bridge))
    return attach_bridged(options, name, std::string_view(name.kind).substr(bridge.size()));
  refuse_settings(options);
  if (name.kind == "intaglio") {
    refuse(options, {{options.dither, "--dither"}});
    const HidApi& api = HidApi::over(name.way);
    return std::make_unique<OwnDisplay>(api, find(api, options, name, is_ours));
  }
  const auto kinds = hal::hid::lcd_devices();
  if (std::ranges::any_of(kinds, [&](const auto& kind) { return name.kind == kind.name; })) {
    const HidApi& api = HidApi::over(name.way);
    const HidDevice found = find(api, options, name, [&](const HidDevice& d) {
      const auto* const kind = lcd_of(d);
      return kind != nullptr && name.kind == kind->name;
    });
    return std::make_unique<KeyboardDisplay>(api, found, *lcd_of(found), options);
  }
  throw Failure("'" + options.panel + "' is no USB HID display: " + std::string(forms));
}

std::vector<std::string> list_hid() {
  std::vector<std::string> all;
  std::vector<HidDevice> devices;
  try {
    devices = HidApi::over(HidApi::Way::hidraw).devices();
  } catch (const hal::hid::HidError& error) {
    return {std::string("(") + error.what() + ')'};
  }
  for (const HidDevice& d : devices) {
    std::string panel;
    if (is_ours(d)) {
      panel = "intaglio" + (d.serial.empty() ? "" : ':' + d.serial);
    } else if (const auto* const kind = lcd_of(d); kind != nullptr) {
      panel = kind->name;
    } else if (is_bridge(d)) {
      panel = "mcp2221/ssd1306@3c";
    } else {
      continue;
    }
    const std::string line = "--panel hid:" + panel + ": " + d.title() + " at " + d.path;
    // hidapi lists a device once a usage.
    if (std::ranges::find(all, line) == all.end()) all.push_back(line);
  }
  return all;
}

}  // namespace host
