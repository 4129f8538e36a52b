// SPDX-License-Identifier: MIT
//
// Frame buffer devices: "fb:/dev/fb0", "fb:/dev/fb0@320x240".
#include <hal/linux/fb_panel.hpp>
#include <host/attach/backend.hpp>

#include <utility>

namespace host {

namespace {

class FbAttached final : public AttachedPanel {
 public:
  explicit FbAttached(const ScreenName& name) : panel_(name.device, {name.width, name.height}) {
    if (!panel_.tells_vblanks()) notices_ = panel_.name() + ": it tells no VBLANKs; a timer stands in\n";
  }
  hal::Panel& panel() override { return panel_; }
  std::string description() const override {
    const hal::Capabilities& c = panel_.capabilities();
    return "a picture of " + std::to_string(c.width) + 'x' + std::to_string(c.height) + ", on " +
           panel_.name() +
           (panel_.has_hardware_palette() ? " with a palette of its own" : " in its colours") +
           (panel_.pans() ? ", panning" : ", copied");
  }
  std::string notices() override { return std::exchange(notices_, {}); }
  std::string fault() const override { return panel_.fault(); }
  std::string counters() const override {
    return "hardware_palette " + std::to_string(panel_.has_hardware_palette() ? 1 : 0) + "\npanning " +
           std::to_string(panel_.pans() ? 1 : 0) + '\n';
  }
  bool keep() override {
    panel_.keep();
    return true;
  }

 private:
  hal::linux_io::FbPanel panel_;
  std::string notices_;
};

}  // namespace

std::unique_ptr<AttachedPanel> attach_fb(const AttachOptions& options) {
  return std::make_unique<FbAttached>(screen_of(options));
}

std::vector<std::string> list_fb() {
  std::vector<std::string> all;
  for (const std::string& path : files_of("/dev", "fb")) {
    const std::string what = hal::linux_io::fb_description(path);
    if (!what.empty())
      all.push_back(std::string("--panel fb:").append(path).append(": frame buffer, ").append(what));
  }
  return all;
}

}  // namespace host
