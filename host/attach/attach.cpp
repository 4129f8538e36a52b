// SPDX-License-Identifier: MIT
#include <host/attach/attach.hpp>
#include <host/attach/backend.hpp>
#include <host/failure.hpp>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <system_error>
#include <utility>

namespace host {

namespace {

/// Everything that this build can drive.
std::vector<Backend> backends() {
  std::vector<Backend> all;
#ifdef HOST_ATTACH_WIRES
  all = wired_backends();
#endif
#ifdef HOST_ATTACH_HID
  all.push_back({"hid:", "displays on USB HID", attach_hid});
#endif
#ifdef HOST_ATTACH_KMS
  all.push_back({"kms:", "a screen of this machine, by its graphics driver", attach_kms});
#endif
#ifdef HOST_ATTACH_FB
  all.push_back({"fb:", "a frame buffer device", attach_fb});
#endif
  return all;
}

std::string_view scheme_of(std::string_view panel) {
  const std::size_t colon = panel.find(':');
  return colon == std::string_view::npos ? std::string_view() : panel.substr(0, colon + 1U);
}

bool wired(const AttachOptions& options) {
  return !options.spi.empty() || !options.i2c.empty() || !options.bitbang.empty();
}

/// Options that a panel without wires has no use for are said, not passed over. On USB there are some that
/// turn and dim: that backend knows which.
void refuse_wire_options(const AttachOptions& o) {
  const bool no_settings = scheme_of(o.panel) != "hid:";
  const std::pair<bool, const char*> all[] = {{!o.data_command.empty(), "--dc"},
                                              {!o.reset.empty(), "--reset"},
                                              {!o.te.empty(), "--te"},
                                              {!o.size.empty(), "--size"},
                                              {!o.offset.empty(), "--offset"},
                                              {no_settings && o.rotate != 0, "--rotate"},
                                              {no_settings && o.invert, "--invert"},
                                              {no_settings && o.dither, "--dither"},
                                              {o.bgr, "--bgr"},
                                              {o.mirror, "--mirror"},
                                              {no_settings && o.contrast.has_value(), "--contrast"}};
  for (const auto& [given, option] : all)
    if (given) throw Failure("--panel " + o.panel + " knows no " + option);
}

}  // namespace

std::string device_of(const AttachOptions& options) {
  return options.panel.substr(scheme_of(options.panel).size());
}

std::vector<std::string> files_of(const std::string& folder, const std::string& beginning) {
  std::vector<std::string> found;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(beginning)) found.push_back(entry.path().string());
  }
  std::ranges::sort(found);
  return found;
}

ScreenName screen_of(const AttachOptions& options) {
  const std::string all = device_of(options);
  const std::size_t at = all.find('@');
  ScreenName name{all.substr(0, at)};
  if (name.device.empty())
    throw Failure("--panel " + options.panel + " names no device, as in kms:/dev/dri/card0");
  if (at == std::string::npos) return name;
  char rest = 0;
  if (std::sscanf(all.c_str() + at, "@%5dx%5d%c", &name.width, &name.height, &rest) != 2 || name.width < 1 ||
      name.height < 1)
    throw Failure("--panel " + options.panel + ": the size of a picture is as in @320x240");
  return name;
}

bool means_attached(const AttachOptions& options) {
  return wired(options) || !scheme_of(options.panel).empty();
}

std::unique_ptr<AttachedPanel> attach(const AttachOptions& options) {
  const std::string_view scheme = scheme_of(options.panel);
  if (!scheme.empty() && wired(options))
    throw Failure("--panel " + options.panel + " has no wires: leave --spi, --i2c and --bitbang out");
  if (!scheme.empty()) refuse_wire_options(options);
  const std::string_view wanted = scheme.empty() ? std::string_view(options.panel) : scheme;
  const std::vector<Backend> all = backends();
  const auto found = std::ranges::find(all, wanted, &Backend::name);
  if (found == all.end()) {
    std::string names;
    for (const Backend& backend : all) names += (names.empty() ? "" : ", ") + std::string(backend.name);
    throw Failure("no real panel is called '" + std::string(wanted) + "'" +
                  (names.empty() ? "; this build can drive none" : "; this build can drive: " + names));
  }
  try {
    return found->attach(options);
  } catch (const Failure&) {
    throw;
  } catch (const std::exception& error) {
    throw Failure(error.what());
  }
}

std::vector<std::string> list_attached() {
  std::vector<std::string> all;
  const auto add = [&all](const std::vector<std::string>& some) {
    all.insert(all.end(), some.begin(), some.end());
  };
#ifdef HOST_ATTACH_WIRES
  add(list_wires());
#endif
#ifdef HOST_ATTACH_HID
  add(list_hid());
#endif
#ifdef HOST_ATTACH_KMS
  add(list_kms());
#endif
#ifdef HOST_ATTACH_FB
  add(list_fb());
#endif
  static_cast<void>(add);
  return all;
}

}  // namespace host
