// SPDX-License-Identifier: MIT
//
// Adaptive supersampling: more samples only where samples differ.
//
// Rule: a pixel is looked at in its four corners and its middle. If all are inside, it is full, if none is,
// it is empty; otherwise its level is the number of scale x scale samples that are inside, in 1/255 of all,
// rounded to nearest. Places are enlarged ones (enlargement.hpp), so the samples are exactly those of the box
// of supersample.hpp, and corners are shared with neighbours and looked at once a row.
//
// Error bound: where one straight edge crosses the pixel, the level is that of the box: 1/(2*scale) of the
// pixel and half a level. For a half-plane that holds all corners holds the pixel, and one that holds none
// misses it. What passes between the corners and the middle (slivers, small objects) is lost whole: that is
// the price. Bit budget: places within the domain.
// Textbook: section 2.8.2. Worst known input: a line thinner than a pixel, which flickers along its way.
#pragma once

#include <intaglio/raster/coverage.hpp>
#include <intaglio/raster/enlargement.hpp>
#include <intaglio/raster/sample_level.hpp>
#include <intaglio/status.hpp>

#include <concepts>

namespace intaglio::raster {

/// Hands over the coverage of the pixels of `area` (in the domain) inside the sink's clip. `inside(place)`
/// says if a place is inside; places are in 1/256 of a pixel enlarged by `Enlargement(scale)`, 2 <= scale
/// <= 8. Errors: rectangle (outside the domain), steps (another scale); nothing is handed over then. Cost:
/// three questions a pixel and two more a row; scale * scale more for each pixel that an edge crosses.
template <CoverageSink S, std::predicate<linear::SubPoint> Inside>
Status cover_adaptively(S&& sink, const linear::Rect& area, int scale, Inside inside) {
  if (!linear::in_domain(area)) return {Error::out_of_domain, Argument::rectangle};
  if (scale < 2 || scale > Enlargement::limit) return {Error::out_of_range, Argument::steps};
  const linear::Rect box = linear::intersect(Enlargement(scale).window(sink.clip()), area);
  // Without a column to look at, the left corners may be places that there are not.
  if (box.empty()) return {};
  const detail::SampleLevels levels(scale * scale);
  const int pixel = scale * linear::subpixel_one;
  const int middle = pixel / 2;
  detail::CoverageRun run(sink);
  for (int y = box.y; y < box.bottom(); ++y) {
    const int top = y * pixel - linear::subpixel_one / 2;
    int left = box.x * pixel - linear::subpixel_one / 2;
    const auto corners_at = [&](int x) {
      return (inside({x, top}) ? 1 : 0) + (inside({x, top + pixel}) ? 1 : 0);
    };
    int left_corners = corners_at(left);
    for (int x = box.x; x < box.right(); ++x, left += pixel) {
      const int right_corners = corners_at(left + pixel);
      const int same = left_corners + right_corners + (inside({left + middle, top + middle}) ? 1 : 0);
      left_corners = right_corners;
      int covered = 0;
      if (same == 5) {
        covered = levels.total();
      } else if (same != 0) {
        for (int v = 0; v < scale; ++v)
          for (int u = 0; u < scale; ++u)
            covered +=
                inside({(x * scale + u) * linear::subpixel_one, (y * scale + v) * linear::subpixel_one}) ? 1
                                                                                                         : 0;
      }
      run.add(y, x, x + 1, levels(covered));
    }
  }
  run.flush();
  return {};
}

}  // namespace intaglio::raster
