// SPDX-License-Identifier: MIT
//
// Screens of this machine by their graphics driver: "kms:/dev/dri/card0", "kms:/dev/dri/card0@320x240".
#include <hal/linux/kms_panel.hpp>
#include <host/attach/backend.hpp>

#include <utility>

namespace host {

namespace {

class KmsAttached final : public AttachedPanel {
 public:
  explicit KmsAttached(const ScreenName& name) : panel_(name.device, {name.width, name.height}) {
    if (!panel_.tells_vblanks())
      notices_ = panel_.name() + ": its driver tells no VBLANKs; a timer stands in\n";
  }
  hal::Panel& panel() override { return panel_; }
  std::string description() const override {
    const hal::Capabilities& c = panel_.capabilities();
    return "a picture of " + std::to_string(c.width) + 'x' + std::to_string(c.height) + ", on " +
           panel_.name();
  }
  std::string notices() override { return std::exchange(notices_, {}); }
  std::string fault() const override { return panel_.fault(); }
  std::string counters() const override { return "page_flips " + std::to_string(panel_.flips()) + '\n'; }

 private:
  hal::linux_io::KmsPanel panel_;
  std::string notices_;
};

}  // namespace

std::unique_ptr<AttachedPanel> attach_kms(const AttachOptions& options) {
  return std::make_unique<KmsAttached>(screen_of(options));
}

std::vector<std::string> list_kms() {
  std::vector<std::string> all;
  for (const std::string& path : files_of("/dev/dri", "card"))
    for (const std::string& screen : hal::linux_io::kms_screens(path))
      all.push_back(std::string("--panel kms:").append(path).append(": screen, ").append(screen));
  return all;
}

}  // namespace host
