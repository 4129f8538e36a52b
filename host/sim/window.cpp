// SPDX-License-Identifier: MIT
//
// The simulator's window, in whole multiples of a pixel.
#include <host/failure.hpp>
#include <host/sim/viewer.hpp>

#include <SDL.h>
#include <algorithm>
#include <cstdlib>

namespace host {

namespace {

/// The release function of a resource of SDL as a deleter.
template <auto release>
struct Release {
  template <class T>
  void operator()(T* resource) const {
    release(resource);
  }
};

[[noreturn]] void fail(const std::string& what) {
  throw Failure("cannot open a window: " + what + ": " + SDL_GetError());
}

class Window final : public Viewer {
 public:
  Window(const std::string& title, int width, int height, int scale) {
    if (scale == 0) scale = fitting_scale(width, height);
    window_.reset(SDL_CreateWindow(title.c_str(), SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED,
                                   width * scale, height * scale, SDL_WINDOW_RESIZABLE));
    if (!window_) fail("window");
    renderer_.reset(SDL_CreateRenderer(window_.get(), -1, 0));
    if (!renderer_) fail("renderer");
    SDL_RenderSetLogicalSize(renderer_.get(), width, height);
    SDL_RenderSetIntegerScale(renderer_.get(), SDL_TRUE);
    texture_.reset(SDL_CreateTexture(renderer_.get(), SDL_PIXELFORMAT_RGB24, SDL_TEXTUREACCESS_STREAMING,
                                     width, height));
    if (!texture_) fail("texture");
  }

  bool show(const RgbPicture& picture) override {
    SDL_UpdateTexture(texture_.get(), nullptr, picture.bytes.data(), 3 * picture.width);
    SDL_RenderClear(renderer_.get());
    SDL_RenderCopy(renderer_.get(), texture_.get(), nullptr, nullptr);
    SDL_RenderPresent(renderer_.get());
    bool on = true;
    for (SDL_Event event; SDL_PollEvent(&event) != 0;) {
      if (event.type == SDL_QUIT) on = false;
      if (event.type == SDL_KEYDOWN &&
          (event.key.keysym.sym == SDLK_ESCAPE || event.key.keysym.sym == SDLK_q))
        on = false;
    }
    return on;
  }

 private:
  /// Starts SDL's video before the members that need it, and stops it after them.
  struct Video {
    Video() {
      SDL_SetHint(SDL_HINT_RENDER_SCALE_QUALITY, "nearest");
      SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
      if (SDL_InitSubSystem(SDL_INIT_VIDEO) != 0) fail("display");
      // Without a display SDL falls back to windows that no one can see, nor close.
      const std::string driver = SDL_GetCurrentVideoDriver();
      if (std::getenv("SDL_VIDEODRIVER") == nullptr && (driver == "dummy" || driver == "offscreen")) {
        SDL_Quit();
        throw Failure("--window: there is no display");
      }
    }
    ~Video() { SDL_Quit(); }
    Video(const Video&) = delete;
    Video& operator=(const Video&) = delete;
  };

  /// The largest whole scale that leaves a quarter of the screen free; 1 for pictures larger than that.
  [[nodiscard]] static int fitting_scale(int width, int height) {
    SDL_Rect screen{};
    if (SDL_GetDisplayUsableBounds(0, &screen) != 0) return 1;
    return std::clamp(std::min(screen.w * 3 / 4 / width, screen.h * 3 / 4 / height), 1, 16);
  }

  Video video_;
  std::unique_ptr<SDL_Window, Release<SDL_DestroyWindow>> window_;
  std::unique_ptr<SDL_Renderer, Release<SDL_DestroyRenderer>> renderer_;
  std::unique_ptr<SDL_Texture, Release<SDL_DestroyTexture>> texture_;
};

}  // namespace

bool window_possible() {
  const auto set = [](const char* name) {
    const char* const value = std::getenv(name);
    return value != nullptr && *value != '\0';
  };
  return set("DISPLAY") || set("WAYLAND_DISPLAY");
}

std::unique_ptr<Viewer> open_window(const std::string& title, int width, int height, int scale) {
  return std::make_unique<Window>(title, width, height, scale);
}

}  // namespace host
