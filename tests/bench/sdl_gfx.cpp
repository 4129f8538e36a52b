// SPDX-License-Identifier: MIT
//
// SDL2_gfx on SDL's software renderer, which draws to 32 bits a pixel. It has neither sub-pixel vertices nor
// a winding rule.
#include <tests/bench/painter.hpp>

#include <SDL.h>
#include <SDL2_gfxPrimitives.h>
#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <vector>

namespace bench {
namespace {

class SdlGfx final : public Painter {
 public:
  SdlGfx()
      : surface_(SDL_CreateRGBSurfaceWithFormat(0, width, height, 32, SDL_PIXELFORMAT_ARGB8888)),
        renderer_(surface_ != nullptr ? SDL_CreateSoftwareRenderer(surface_) : nullptr) {
    if (renderer_ == nullptr) throw std::runtime_error(SDL_GetError());
  }
  ~SdlGfx() override {
    SDL_DestroyRenderer(renderer_);
    SDL_FreeSurface(surface_);
  }

  void clear() override {
    SDL_SetRenderDrawColor(renderer_, 0, 0, 0, 255);
    SDL_RenderClear(renderer_);
  }
  bool draw(const Shape& shape) override {
    return std::visit([&](const auto& s) { return draw_one(s); }, shape);
  }
  void finish() override { SDL_RenderFlush(renderer_); }
  [[nodiscard]] int level(int x, int y) const override {
    const auto* const row = static_cast<const std::uint8_t*>(surface_->pixels) + y * surface_->pitch;
    return row[4 * x];
  }

 private:
  static Sint16 s(int v) { return static_cast<Sint16>(v); }

  bool draw_one(const Line& l) {
    return lineRGBA(renderer_, s(l.a.x), s(l.a.y), s(l.b.x), s(l.b.y), 255, 255, 255, 255) == 0;
  }
  bool draw_one(const ThickLine& l) {
    return thickLineRGBA(renderer_, s(l.a.x), s(l.a.y), s(l.b.x), s(l.b.y), static_cast<Uint8>(l.across), 255,
                         255, 255, 255) == 0;
  }
  bool draw_one(const Circle& c) {
    const auto call = c.filled ? filledCircleRGBA : circleRGBA;
    return call(renderer_, s(c.centre.x), s(c.centre.y), s(c.radius), 255, 255, 255, 255) == 0;
  }
  bool draw_one(const Ellipse& e) {
    const auto call = e.filled ? filledEllipseRGBA : ellipseRGBA;
    return call(renderer_, s(e.centre.x), s(e.centre.y), s(e.x_radius), s(e.y_radius), 255, 255, 255, 255) ==
           0;
  }
  bool draw_one(const Polygon& p) {
    if (!p.even_odd) return false;
    xs_.clear();
    ys_.clear();
    for (const auto& v : p.vertices) {
      if (v.x % 256 != 0 || v.y % 256 != 0) return false;
      xs_.push_back(s(v.x / 256));
      ys_.push_back(s(v.y / 256));
    }
    return filledPolygonRGBA(renderer_, xs_.data(), ys_.data(), static_cast<int>(xs_.size()), 255, 255, 255,
                             255) == 0;
  }

  SDL_Surface* surface_;
  SDL_Renderer* renderer_;
  std::vector<Sint16> xs_;
  std::vector<Sint16> ys_;
};

}  // namespace

std::unique_ptr<Painter> make_sdl_gfx() { return std::make_unique<SdlGfx>(); }

}  // namespace bench
