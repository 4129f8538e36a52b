// SPDX-License-Identifier: MIT
//
// Errors of turned pictures, against bilinear interpolation in real numbers between the outermost centres.
#include <host/lab/errors/report.hpp>
#include <tests/oracle/turned_value.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <firmware/lab/families/image_rotate.hpp>

namespace {

struct ImageRotateErrors {
  using Family = lab::ImageRotate;
  /// The angle in 1/65536 turn, and the seed of a picture of blacks and whites.
  using Case = std::array<std::int64_t, 2>;

  template <class Visit>
  static std::string cases(int /*load*/, host::lab::Effort effort, Visit&& visit) {
    visit(Case{8192, 1});
    const std::int64_t stride = effort.full() ? 31 : 4001;
    for (std::int64_t steps = 0; steps < 65536; steps += stride) visit(Case{steps, steps});
    return "angles in steps of 31, each with its own noise of blacks and whites";
  }
  template <class R>
  static double error(int /*load*/, const Case& c) {
    constexpr int w = Family::columns;
    constexpr int h = Family::rows;
    std::array<std::uint8_t, std::size_t{1200}> values{};
    lab::Random random(static_cast<std::uint32_t>(c[1]));
    for (auto& value : values) value = random.between(0, 1) == 0 ? 0 : 255;
    const auto source = lab::image::Picture<lab::image::Indexed8>::over(values, {w, h});
    const auto target = lab::canvas();
    const auto turn = Family::turned(static_cast<int>(c[0]));
    for (int y = 95; y < 146; ++y)
      for (int x = 135; x < 186; ++x) target.set(x, y, 0);
    R{}(target, turn, source.value()).ignore();
    const auto value = [&values](int column, int row) {
      return static_cast<double>(values.at(static_cast<std::size_t>(row * w + column)));
    };
    double worst = 0;
    for (int y = 95; y < 146; ++y)
      for (int x = 135; x < 186; ++x) {
        double exact = 0;
        // A pixel between the outermost centres is drawn by all rungs but the shears, at the picture's sides.
        if (oracle::turned_value(x, y, w, h, static_cast<int>(c[0]), turn.pivot.x / 256.0,
                                 turn.pivot.y / 256.0, 160, 120, value, exact))
          worst = std::max(worst, std::abs(target.get(x, y) - exact));
      }
    return worst;
  }
};

}  // namespace

host::lab::FamilyReport host::lab::family_report() { return report<ImageRotateErrors>(); }
