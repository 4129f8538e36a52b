// SPDX-License-Identifier: MIT
//
// Errors of turned pictures: how far from where it should be a pixel takes its value, between the source's
// outermost centres.
#include <host/lab/errors/report.hpp>
#include <tests/oracle/turned_place.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <firmware/lab/families/image_rotate.hpp>
#include <vector>

namespace {

struct ImageRotateErrors {
  using Family = lab::ImageRotate;
  /// The angle in 1/65536 turn.
  using Case = std::array<std::int64_t, 1>;

  template <class Visit>
  static std::string cases(int /*load*/, host::lab::Effort effort, Visit&& visit) {
    visit(Case{8192});
    const std::int64_t stride = effort.full() ? 31 : 4001;
    for (std::int64_t steps = 0; steps < 65536; steps += stride) visit(Case{steps});
    return "angles in steps of " + std::to_string(stride) + ", all pixels of each";
  }
  template <class R>
  static double error(int /*load*/, const Case& c) {
    constexpr int left = 135;
    constexpr int top = 95;
    constexpr int side = 51;
    const auto target = lab::canvas();
    const auto turn = Family::turned(static_cast<int>(c[0]));
    const oracle::ShownPlaces shown(
        Family::columns, Family::rows, [&](const std::vector<std::uint8_t>& values) {
          std::vector<std::uint8_t> pixels;
          for (int y = top; y < top + side; ++y)
            for (int x = left; x < left + side; ++x) target.set(x, y, 0);
          R{}(target, turn,
              lab::image::Picture<lab::image::Indexed8>::over(values, {Family::columns, Family::rows})
                  .value())
              .ignore();
          for (int y = top; y < top + side; ++y)
            pixels.insert(pixels.end(), target.byte_at(left, y), target.byte_at(left, y) + side);
          return pixels;
        });
    double worst = 0;
    for (int i = 0; i < side * side; ++i) {
      const int x = left + i % side;
      const int y = top + i / side;
      const auto place =
          oracle::turned_place(x, y, static_cast<int>(c[0]), {turn.pivot.x / 256.0, turn.pivot.y / 256.0},
                               turn.position.x / 256.0, turn.position.y / 256.0);
      const auto pixel = static_cast<std::size_t>(i);
      if (shown.drawn(pixel) && place.inside(Family::columns, Family::rows))
        worst = std::max(worst, place.distance(shown[pixel]));
    }
    return worst;
  }
};

}  // namespace

host::lab::FamilyReport host::lab::family_report() { return report<ImageRotateErrors>(); }
