// SPDX-License-Identifier: MIT
#include <intaglio/clip/clip_stack.hpp>
#include <tests/oracle/random.hpp>

#include <climits>
#include <gtest/gtest.h>

#include <vector>

namespace {

using intaglio::Argument;
using intaglio::Error;
using intaglio::Status;
using intaglio::clip::ClipStack;
using intaglio::linear::Rect;

bool holds(const Rect& r, int x, int y) {
  return x >= r.x && x < r.x + r.width && y >= r.y && y < r.y + r.height;
}

TEST(ClipStack, TopHoldsExactlyWhatAllRectanglesHold) {
  oracle::Random random(5);
  ClipStack<6> stack({1, 2, 12, 10});
  std::vector<Rect> pushed{{1, 2, 12, 10}};
  int wrong = 0;
  for (int step = 0; step < 3000; ++step) {
    if (pushed.size() < 7 && random.between(0, 2) != 0) {
      const Rect area{random.between(-3, 12), random.between(-3, 12), random.between(-2, 14),
                      random.between(-2, 14)};
      ASSERT_TRUE(stack.push(area).ok());
      pushed.push_back(area);
    } else if (pushed.size() > 1) {
      ASSERT_TRUE(stack.pop().ok());
      pushed.pop_back();
    }
    const Rect top = stack.top();
    if (top.width < 0 || top.height < 0 || stack.depth() + 1 != static_cast<int>(pushed.size())) ++wrong;
    for (int y = -4; y < 20; ++y)
      for (int x = -4; x < 20; ++x) {
        bool in_all = true;
        for (const Rect& area : pushed) in_all = in_all && holds(area, x, y);
        if (holds(top, x, y) != in_all) ++wrong;
      }
  }
  EXPECT_EQ(wrong, 0) << random.seed_text();
}

TEST(ClipStack, FullEmptyAndBadCallsChangeNothing) {
  ClipStack<2> stack({0, 0, 100, 100});
  EXPECT_EQ(stack.pop(), (Status{Error::empty, Argument::count}));
  for (const int bad : {INT_MIN, INT_MAX}) {
    EXPECT_EQ(stack.push({bad, 0, 1, 1}), (Status{Error::out_of_domain, Argument::rectangle}));
    EXPECT_EQ(stack.push({0, 0, bad, 1}), (Status{Error::out_of_domain, Argument::rectangle}));
  }
  EXPECT_EQ(stack.depth(), 0);
  EXPECT_TRUE(stack.push({10, 10, 50, 50}).ok());
  EXPECT_TRUE(stack.push({20, 0, 100, 20}).ok());
  const Rect top = stack.top();
  EXPECT_EQ(top, (Rect{20, 10, 40, 10}));
  EXPECT_EQ(stack.push({0, 0, 1, 1}), (Status{Error::too_large, Argument::count, 2}));
  EXPECT_EQ(stack.top(), top);
  EXPECT_EQ(stack.depth(), 2);
}

TEST(ClipStack, IsAValue) {
  ClipStack<3> outer({0, 0, 100, 100});
  ASSERT_TRUE(outer.push({0, 0, 50, 50}).ok());
  ClipStack<3> inner = outer;
  ASSERT_TRUE(inner.push({10, 10, 10, 10}).ok());
  EXPECT_EQ(outer.top(), (Rect{0, 0, 50, 50}));
  EXPECT_EQ(inner.top(), (Rect{10, 10, 10, 10}));
}

TEST(ClipStack, BoundsOutsideTheDomainHoldNothing) {
  const ClipStack<1> stack({INT_MIN, INT_MAX, INT_MAX, INT_MIN});
  EXPECT_TRUE(stack.top().empty());
  EXPECT_GE(stack.top().width, 0);
  const ClipStack<1> turned({0, 0, -5, 10});
  EXPECT_EQ(turned.top().width, 0);
}

}  // namespace
