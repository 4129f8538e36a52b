// SPDX-License-Identifier: MIT
//
// Errors of stretched pictures, against bilinear interpolation in real numbers.
#include <host/lab/errors/report.hpp>
#include <tests/oracle/bilinear.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <firmware/lab/families/image_scale.hpp>

namespace {

struct ImageScaleErrors {
  using Family = lab::ImageScale;
  /// The seed of a picture of blacks and whites; 0 is a checkerboard.
  using Case = std::array<std::int64_t, 1>;

  template <class Visit>
  static std::string cases(int /*load*/, host::lab::Effort effort, Visit&& visit) {
    const std::int64_t pictures = effort.full() ? 500 : 20;
    for (std::int64_t seed = 0; seed < pictures; ++seed) visit(Case{seed});
    return "a checkerboard, and noise of blacks and whites with seeds from 1 on";
  }
  template <class R>
  static double error(int load, const Case& c) {
    std::array<std::uint8_t, static_cast<std::size_t>(Family::columns * Family::rows)> values{};
    lab::Random random(static_cast<std::uint32_t>(c[0]));
    for (std::size_t i = 0; i < values.size(); ++i) {
      const int board = static_cast<int>(i + i / Family::columns) % 2;
      values.at(i) = (c[0] == 0 ? board : random.between(0, 1)) == 0 ? 0 : 255;
    }
    const auto in = Family::input(load, 0);
    const auto target = lab::canvas();
    const auto source =
        lab::image::Picture<lab::image::Indexed8>::over(values, {Family::columns, Family::rows});
    R{}(target, {0, 0, in.width, in.height}, source.value()).ignore();
    const auto value = [&values](int column, int row) {
      return static_cast<double>(values.at(static_cast<std::size_t>(row * Family::columns + column)));
    };
    double worst = 0;
    for (int y = 0; y < in.height; ++y)
      for (int x = 0; x < in.width; ++x)
        worst =
            std::max(worst, std::abs(target.get(x, y) - oracle::bilinear(x, y, Family::columns, Family::rows,
                                                                         in.width, in.height, value)));
    return worst;
  }
};

}  // namespace

host::lab::FamilyReport host::lab::family_report() { return report<ImageScaleErrors>(); }
