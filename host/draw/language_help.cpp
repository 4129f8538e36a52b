// SPDX-License-Identifier: MIT
//
// What `intaglio-draw --help` says about the drawing language.
#include <host/draw/program.hpp>

namespace host::draw {

std::string_view language_help() {
  return R"(The drawing language, one command a line, # begins a comment:
  surface W H BITS           the first command: width, height, 1, 2, 4 or 8 bits a pixel
  palette INDEX R G B        0..255 each; at first a grey ramp, index 0 black, the last white
  color INDEX                what is drawn with (or colour); at first the last index
  mode set|xor               store the index, or exclusive-or it into what is there
  aa off | aa METHOD [light] smooth edges: area (exact), pitteway (convex), abuffer4x4, abuffer4x8, adaptive2 to 8,
                             stochastic2 to 8, box2 to 8 (samples a side), bartlettSxW (S = 2 to 5 or 7 samples a side,
                             W to 8 a window). Short: box, adaptive, stochastic (4 samples a side), abuffer,
                             bartlett3, 5 and 7. Polylines and boolean need box or bartlett; dash can't.
                             Colours are mixed by their codes, or as light, to the palette's nearest; 1 bit is
                             dithered. Curves are drawn as polygons not 1/256 pixel off, but for box and bartlett
  clip X Y W H | clip none   draw only inside
  clippoly [evenodd|nonzero] X Y X Y X Y ... [/ X Y ...] | clippoly none
                             draw only inside this polygon, too; a flood spreads where it doesn't draw, as well
  pixel X Y
  line X0 Y0 X1 Y1           both ends included
  dash ON OFF X0 Y0 X1 Y1    of that line ON pixels and OFF not, in turn, from X0 Y0 on
  thickline X0 Y0 X1 Y1 WIDTH [butt|square|round]
                             WIDTH across the line, whichever way it runs; square and round ends stick out by half
                             of it
  polyline WIDTH miter|bevel|round [butt|square|round] [closed] [limit L] X Y X Y ...
                             thick lines joined, each pixel once; a miter that reaches further than L (1..16, at
                             first 4) halves of WIDTH becomes a bevel
  rect X Y W H               outline; fillrect: filled
  circle X Y R               outline; disc: filled, outline included
  evencircle X Y D           circle with the diameter D, even or odd, and its top left at X Y; evendisc: filled
  ellipse X Y RX RY          outline; fillellipse: filled, outline included
  ring X Y R_IN R_OUT        the disc of radius R_OUT without that of radius R_IN
  arc X Y R START SWEEP      part of a circle, in 1/65536 turn, clockwise from three o'clock, the larger angle left
                             out; negative sweeps go the other way, a turn or more is all. pie: filled to the
                             centre; chord: filled to the line between the ends
  ellipsearc X Y RX RY START SWEEP
                             the same of an ellipse, angles as seen from the centre; ellipsepie, ellipsechord
  roundrect X Y W H R        outline; fillroundrect: filled. Four radii instead of R go clockwise from top left
  triangle X Y X Y X Y       filled
  polygon evenodd|nonzero X Y X Y X Y ... [/ X Y ...]
                             filled; / begins another contour (a hole, an island)
  coverage X Y X Y X Y ... [/ X Y ...]
                             even-odd; index = how much of the pixel is covered, 0..255; needs 8 bits a pixel
  boolean intersection|union|a-b|b-a X Y X Y X Y ... / X Y X Y X Y ...
                             two polygons combined, each by evenodd and within 2048 pixels; draws the result, and
                             prints its contours, exactly, as `contour X Y X Y ...`, and its area as `area N/D`
  flood 4|8 X Y              the pixels around X Y of its index, joined by 4 or 8 neighbours inside the clip
  sprite FILE X Y [SCALE ANGLE]
                             a PNG with its top left at X Y, each pixel in the nearest colour of the palette; those
                             less than half opaque are left out. SCALE (1/256 to 256) and ANGLE (in 1/65536 turn,
                             clockwise) are about its middle, which stays
  stretch FILE X Y W H       a PNG in this rectangle
  dither off | dither METHOD [LEVELS]
                             later sprites and stretches in greys, on the first LEVELS indices (all if not given),
                             black to white: none (the nearest level), bayer2, bayer4, bayer8 (thresholds of a
                             matrix), threetap, fourtap (Floyd and Steinberg), serpentine (what a pixel is off by
                             goes to its neighbours, from the surface's top left on)
  method NAME                how the next primitive is drawn, to the same pixels: triangle walk (the default), box,
                             blocks; polygon active (the default), basic, critical; line exact (the default),
                             distance. To others: line line1, line2 (whole pixels; the longer, the less exact);
                             thickline across (the default), minor (WIDTH whole pixels in each column or row); sprite
                             with an angle zoom (the default), or with SCALE 1 shear (no pixel is lost or doubled) or
                             bilinear; stretch nearest (the default), bilinear, or box (each pixel the mean of what
                             lies under it, best to shrink)
  font NAME                  fixed_6x13 (the default), fixed_5x8, sans_11, digits_16, digits_28, digits_48
  text X Y "UTF-8" [left|centre|right [top|middle|baseline|bottom]]
                             X Y is the text's top left, or where its lines begin, have their middle or end, and its
                             top, middle, first base line or bottom is; escapes \" \\ and \n (next line)
The surface is black (index 0) at first. Coordinates are whole pixels up to 2^20 either way, and may lie outside
the surface. Those of line, thickline, polyline, triangle, polygon, clippoly, boolean and coverage may be decimals
or fractions such as 7/3; they are rounded to the nearest 1/256, halves away from zero. An error says
`line N: ...`, nothing is written then, and the exit code is 1.)";
}

}  // namespace host::draw
