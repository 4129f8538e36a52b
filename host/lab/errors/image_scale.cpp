// SPDX-License-Identifier: MIT
//
// Errors of stretched pictures: enlarged ones against bilinear interpolation in real numbers, shrunk ones
// against the mean over each pixel's box.
#include <host/lab/errors/report.hpp>
#include <tests/oracle/bilinear.hpp>
#include <tests/oracle/box.hpp>
#include <tests/oracle/scale.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <firmware/lab/families/image_scale.hpp>
#include <vector>

namespace {

struct ImageScaleErrors {
  using Family = lab::ImageScale;
  /// The seed of a picture of blacks and whites; 0 is a checkerboard; -1 is black where a pixel is the
  /// nearest one to a pixel that is shown, and white elsewhere.
  using Case = std::array<std::int64_t, 1>;

  template <class Visit>
  static std::string cases(int load, host::lab::Effort effort, Visit&& visit) {
    const std::int64_t pictures = effort.full() ? 500 : 20;
    for (std::int64_t seed = Family::shrinks(load) ? -1 : 0; seed < pictures; ++seed) visit(Case{seed});
    return Family::shrinks(load)
               ? "a checkerboard, a picture white but for what is shown, and noise of blacks and whites"
               : "a checkerboard, and noise of blacks and whites with seeds from 1 on";
  }
  template <class R>
  static double error(int load, const Case& c) {
    const auto in = Family::input(load, 0);
    const std::vector<std::uint8_t> values = picture(in, c[0]);
    const auto target = lab::canvas();
    const auto source = lab::image::Picture<lab::image::Indexed8>::over(values, {in.columns, in.rows});
    R{}(target, {0, 0, in.width, in.height}, source.value()).ignore();
    const auto value = [&](int column, int row) {
      return values[static_cast<std::size_t>(row * in.columns + column)];
    };
    double worst = 0;
    for (int y = 0; y < in.height; ++y)
      for (int x = 0; x < in.width; ++x) {
        const double exact = Family::shrinks(load)
                                 ? static_cast<double>(oracle::box_sum(x, y, in.columns, in.rows, in.width,
                                                                       in.height, value)) /
                                       (in.columns * in.rows)
                                 : oracle::bilinear(x, y, in.columns, in.rows, in.width, in.height, value);
        worst = std::max(worst, std::abs(target.get(x, y) - exact));
      }
    return worst;
  }

 private:
  static std::vector<std::uint8_t> picture(const Family::Input& in, std::int64_t seed) {
    std::vector<std::uint8_t> values(static_cast<std::size_t>(in.columns * in.rows), 255);
    const auto at = [&](int column, int row) -> std::uint8_t& {
      return values[static_cast<std::size_t>(row * in.columns + column)];
    };
    if (seed < 0) {
      for (int y = 0; y < in.height; ++y)
        for (int x = 0; x < in.width; ++x)
          at(oracle::scaled_source(x, in.columns, in.width), oracle::scaled_source(y, in.rows, in.height)) =
              0;
      return values;
    }
    lab::Random random(static_cast<std::uint32_t>(seed));
    for (int row = 0; row < in.rows; ++row)
      for (int column = 0; column < in.columns; ++column)
        if ((seed == 0 ? (column + row) % 2 : random.between(0, 1)) == 0) at(column, row) = 0;
    return values;
  }
};

}  // namespace

host::lab::FamilyReport host::lab::family_report() { return report<ImageScaleErrors>(); }
