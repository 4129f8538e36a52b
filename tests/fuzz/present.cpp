// SPDX-License-Identifier: MIT
//
// The list of what has changed in a frame: everything added is covered, nothing twice, nothing outside.
#include <intaglio/present/dirty_list.hpp>
#include <tests/fuzz/scene.hpp>

namespace fuzz {

void run(Input in) {
  const int width = 1 + in.choice(48);
  const int height = 1 + in.choice(32);
  const int across = 1 << in.choice(4);
  const int down = 1 << in.choice(4);
  intaglio::present::DirtyList list({width, height}, across, down);
  std::vector<Rect> added;
  const Rect frame{0, 0, width, height};
  while (!in.empty() && added.size() < 40) {
    const int x = in.coordinate(0, width);
    const int y = in.coordinate(0, height);
    const int columns = in.length();
    const int rows = in.length();
    const Rect r{x, y, columns, rows};
    const std::size_t before = list.rects().size();
    if (list.add(r).ok())
      added.push_back(r);
    else
      require(list.rects().size() == before, "a rectangle that is refused changes the list");
  }
  oracle::RecordingSink covered(frame);
  for (const Rect& r : list.rects()) {
    require(r.x % across == 0 && r.y % down == 0, "a corner off the panel's grid");
    require(r.right() % across == 0 || r.right() == width, "a right edge off the panel's grid");
    require(r.bottom() % down == 0 || r.bottom() == height, "a lower edge off the panel's grid");
    for (int y = r.y; y < r.bottom(); ++y) covered.span(y, r.x, r.right());
  }
  require(covered.violation().empty(), "a rectangle outside the frame");
  require(covered.most() <= 1, "rectangles that overlap");
  for (const Rect& r : added)
    for_pixels(frame, [&](int x, int y) {
      require(!r.contains({x, y}) || covered.writes(x, y) == 1, "what was added isn't covered");
    });
}

}  // namespace fuzz
