// SPDX-License-Identifier: MIT
//
// Runs a program on a screen: the loop that every board and the simulator share.
//
// Rule: for frame n = 0, 1, …: update(n), draw (once on a whole frame, or once a band), present with the
// palette of the frame; when the frame is on display, tell the caller. The caller may ask for the digest of
// the frame by taking a second argument, and only then is it computed.
#pragma once

#include <intaglio/image/digest.hpp>
#include <intaglio/present/bands.hpp>
#include <intaglio/present/frame_writer.hpp>
#include <intaglio/present/swap_chain.hpp>

#include <concepts>
#include <type_traits>

namespace intaglio::present {

/// A program: draws each frame as a function of its number.
template <class A, class F>
concept App = requires(A& app, const A& drawn, std::uint32_t frame, image::Surface<F> target) {
  app.update(frame);
  { drawn.palette() } -> std::convertible_to<std::span<const std::uint8_t>>;
  { drawn.draw(target) } -> std::same_as<Status>;
};

/// A screen that lends whole frames.
template <class S>
concept FrameScreen = requires(S& screen) {
  screen.begin();
};

namespace detail {

template <class A, FrameScreen S, class Watch>
Status show(const A& app, S& screen, Watch&& watch) {
  auto begun = screen.begin();
  if (!begun.ok()) return begun.status();
  if (const Status s = app.draw(begun.value().surface()); !s.ok()) return s;
  watch(image::Picture<typename S::Format>(begun.value().surface()));
  return screen.present(std::move(begun).value(), app.palette());
}

template <class A, class S, class Watch>
Status show(const A& app, S& screen, Watch&& watch) {
  using F = typename S::Format;
  return screen.present([&app](image::Surface<F> band) { return app.draw(band); }, app.palette(), watch);
}

/// Calls `on_frame`; true if the run goes on.
template <class OnFrame, class... Arguments>
bool tell(OnFrame& on_frame, Arguments... arguments) {
  if constexpr (std::is_same_v<std::invoke_result_t<OnFrame&, Arguments...>, bool>) {
    return on_frame(arguments...);
  } else {
    on_frame(arguments...);
    return true;
  }
}

}  // namespace detail

/// Runs `app` for `frames` frames on a screen (`SwapChain`, `FrameWriter` or `BandWriter`).
/// `on_frame(number, digest)` or `on_frame(number)` is called when a frame is on display; if it answers a
/// `bool`, false ends the run with success. The digest covers the palette that the program loaded or, where
/// colours are fixed, the fixed ones.
/// Errors: what the screen or the program's `draw` answers; the run ends with it.
template <class A, class S, class OnFrame>
requires App<A, typename S::Format> &&
    (std::invocable<OnFrame&, std::uint32_t, std::uint32_t> || std::invocable<OnFrame&, std::uint32_t>)
        [[nodiscard]] Status run(A& app, S& screen, std::uint32_t frames, OnFrame&& on_frame) {
  using Picture = image::Picture<typename S::Format>;
  if (const Status s = screen.status(); !s.ok()) return s;
  const ScreenInfo info = screen.info();
  for (std::uint32_t n = 0; n < frames; ++n) {
    app.update(n);
    if constexpr (std::invocable<OnFrame&, std::uint32_t, std::uint32_t>) {
      const std::span<const std::uint8_t> loaded = app.palette();
      image::FrameDigest digest(info.size, info.palette_entries == 0 ? info.fixed_palette : loaded);
      const Status s = detail::show(app, screen, [&digest](const Picture& rows) { digest.add(rows); });
      if (!s.ok()) return s;
      if (const Status t = screen.wait_until_shown(); !t.ok()) return t;
      if (!detail::tell(on_frame, n, digest.value())) return {};
    } else {
      if (const Status s = detail::show(app, screen, [](const Picture&) {}); !s.ok()) return s;
      if (const Status s = screen.wait_until_shown(); !s.ok()) return s;
      if (!detail::tell(on_frame, n)) return {};
    }
  }
  return {};
}

/// The same without being told.
template <class A, class S>
[[nodiscard]] Status run(A& app, S& screen, std::uint32_t frames) {
  return run(app, screen, frames, [](std::uint32_t) {});
}

}  // namespace intaglio::present
