// SPDX-License-Identifier: MIT
//
// A screen by KMS, on a graphics card that isn't there.
#include "libdrm/fake_card.hpp"

#include <hal/linux/kms_panel.hpp>
#include <intaglio/present/swap_chain.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cerrno>
#include <drm_mode.h>
#include <string>
#include <vector>

namespace {

using fake_card::card;
using hal::Error;
using hal::Part;
using hal::Status;
using hal::linux_io::DeviceError;
using hal::linux_io::Extent;
using hal::linux_io::KmsPanel;
using testing::AllOf;
using testing::HasSubstr;

/// All entries of one colour.
std::vector<std::uint8_t> palette_of(std::uint8_t level) { return std::vector<std::uint8_t>(768, level); }

class Kms : public testing::Test {
 protected:
  Kms() { fake_card::reset(); }
  ~Kms() override {
    EXPECT_EQ(kernel_.open_files, 0) << "files are still open";
    EXPECT_TRUE(card().buffers.empty()) << "buffers are still there";
    EXPECT_TRUE(card().frame_buffers.empty());
    EXPECT_EQ(card().maps, 0) << "memory is still mapped";
  }

  std::string refusal(Extent picture = {}) {
    try {
      KmsPanel("/dev/dri/card0", picture, kernel_);
    } catch (const DeviceError& error) {
      return error.what();
    }
    return "it was accepted";
  }
  static void fill(KmsPanel& panel, int index, std::uint8_t pixel) {
    std::ranges::fill(panel.buffer(index), pixel);
  }

  fake_card::Kernel kernel_;
};

TEST_F(Kms, IsAPanelWithAPaletteOfTheScreensSize) {
  KmsPanel panel("/dev/dri/card0", {}, kernel_);
  const hal::Capabilities& c = panel.capabilities();
  EXPECT_EQ(c.width, 100);
  EXPECT_EQ(c.height, 70);
  EXPECT_EQ(c.palette_entries, 256);
  EXPECT_EQ(c.buffers, 2);
  EXPECT_TRUE(c.vblank_signal);
  EXPECT_EQ(c.refresh_millihertz, 60'000U);
  EXPECT_EQ(panel.buffer(1).size(), 7000U);
}

TEST_F(Kms, ASmallPictureIsEnlargedByAWholeNumberInTheMiddle) {
  KmsPanel panel("/dev/dri/card0", {31, 22}, kernel_);
  std::vector<std::uint8_t> colours(768);
  for (std::size_t i = 0; i < 768; ++i) colours[i] = static_cast<std::uint8_t>(i * 5U);
  const std::span<std::uint8_t> pixels = panel.buffer(1);
  for (std::size_t i = 0; i < pixels.size(); ++i) pixels[i] = static_cast<std::uint8_t>(i * 7U);
  ASSERT_TRUE(panel.show(1, colours).ok());
  card().vblank();
  int wrong = 0;
  for (int y = 0; y < 70; ++y)
    for (int x = 0; x < 100; ++x) {
      // Three times, 93x66, from (3, 2) on.
      std::uint32_t expected = 0;
      if (x >= 3 && x < 96 && y >= 2 && y < 68) {
        const unsigned index = pixels[static_cast<std::size_t>((y - 2) / 3 * 31 + (x - 3) / 3)];
        expected = static_cast<std::uint32_t>(colours[3U * index]) << 16U |
                   static_cast<std::uint32_t>(colours[3U * index + 1U]) << 8U | colours[3U * index + 2U];
      }
      wrong += card().pixel(x, y) != expected;
    }
  EXPECT_EQ(wrong, 0);
}

TEST_F(Kms, FrameAndPaletteAppearTogetherAtTheVblank) {
  KmsPanel panel("/dev/dri/card0", {}, kernel_);
  ASSERT_TRUE(panel.show(1, palette_of(0x11)).ok());
  ASSERT_TRUE(panel.wait_for_vblank().ok());
  EXPECT_EQ(card().pixel(5, 5), 0x111111U);
  fill(panel, 0, 3);
  ASSERT_TRUE(panel.show(0, palette_of(0x22)).ok());
  EXPECT_TRUE(panel.show_pending());
  EXPECT_EQ(card().pixel(5, 5), 0x111111U);
  const std::uint32_t before = panel.vblank_count();
  ASSERT_TRUE(panel.wait_for_vblank().ok());
  EXPECT_FALSE(panel.show_pending());
  EXPECT_EQ(panel.vblank_count(), before + 1U);
  EXPECT_EQ(card().pixel(5, 5), 0x222222U);
  EXPECT_EQ(panel.flips(), 2U);
}

TEST_F(Kms, EveryVblankShowsAFrameThatIsWhole) {
  KmsPanel panel("/dev/dri/card0", {}, kernel_);
  const std::uint32_t first = panel.vblank_count();
  for (unsigned i = 0; i < 600; ++i) {
    fill(panel, static_cast<int>(i % 2U), static_cast<std::uint8_t>(i));
    ASSERT_TRUE(panel.show(static_cast<int>(i % 2U), palette_of(static_cast<std::uint8_t>(i))).ok());
    while (panel.show_pending()) ASSERT_TRUE(panel.wait_for_vblank().ok());
    ASSERT_EQ(card().pixel(99, 69) & 0xFFU, i & 0xFFU);
    ASSERT_EQ(card().pixel(0, 0), card().pixel(99, 69));
  }
  EXPECT_EQ(panel.flips(), 600U);
  EXPECT_EQ(panel.vblank_count() - first, 600U);
}

TEST_F(Kms, ARequestBehindAFlipTakesTheVblankAfterAndTheLastOneWins) {
  KmsPanel panel("/dev/dri/card0", {}, kernel_);
  ASSERT_TRUE(panel.show(0, palette_of(1)).ok());
  ASSERT_TRUE(panel.show(1, palette_of(2)).ok());
  ASSERT_TRUE(panel.show(0, palette_of(3)).ok());
  ASSERT_TRUE(panel.wait_for_vblank().ok());
  EXPECT_EQ(card().pixel(0, 0), 0x010101U);
  EXPECT_TRUE(panel.show_pending());
  ASSERT_TRUE(panel.wait_for_vblank().ok());
  EXPECT_EQ(card().pixel(0, 0), 0x030303U);
  EXPECT_FALSE(panel.show_pending());
  EXPECT_EQ(panel.flips(), 2U);
}

TEST_F(Kms, ItIsToldWhatIsOnDisplayAndWhatWasReplaced) {
  KmsPanel panel("/dev/dri/card0", {}, kernel_);
  EXPECT_EQ(panel.on_display(), 0) << "a panel starts with it";
  ASSERT_TRUE(panel.show(1, palette_of(1)).ok());
  EXPECT_EQ(panel.on_display(), 0) << "before the VBLANK";
  // A flip under way isn't replaced: the next waits for it.
  ASSERT_TRUE(panel.show(0, palette_of(2)).ok());
  EXPECT_FALSE(panel.show_replaced());
  ASSERT_TRUE(panel.show(1, palette_of(3)).ok());
  EXPECT_TRUE(panel.show_replaced());
  card().vblank();
  EXPECT_EQ(panel.on_display(), 1);
  EXPECT_TRUE(panel.show_pending());
  ASSERT_TRUE(panel.show(0, palette_of(4)).ok());
  EXPECT_FALSE(panel.show_replaced()) << "the one before is being flipped to by now";
  card().vblank();
  EXPECT_EQ(panel.on_display(), 1);
  EXPECT_EQ(card().pixel(0, 0), 0x030303U);
  card().vblank();
  EXPECT_EQ(panel.on_display(), 0);
  EXPECT_FALSE(panel.show_pending());
  EXPECT_EQ(card().pixel(0, 0), 0x040404U);
}

TEST_F(Kms, FramesThatReplaceEachOtherAreCountedAsTheyAppeared) {
  KmsPanel panel("/dev/dri/card0", {}, kernel_);
  using Chain = intaglio::present::SwapChain<intaglio::image::Indexed8>;
  Chain chain(panel, {1, intaglio::present::Late::show, intaglio::present::Order::latest});
  std::vector<std::uint32_t> appeared;
  const std::uint32_t first = panel.vblank_count();
  std::uint32_t last_seen = 0;
  const auto look = [&] {
    const std::uint32_t level = card().pixel(0, 0) & 0xFFU;
    if (level != last_seen) appeared.push_back(panel.vblank_count() - first);
    last_seen = level;
  };
  for (int frame = 1; frame <= 40; ++frame) {
    auto drawn = chain.begin();
    look();
    ASSERT_TRUE(drawn.ok());
    for (int i = 0; i < frame * 7 % 4; ++i) {
      card().vblank();
      look();
    }
    ASSERT_TRUE(chain.present(std::move(drawn).value(), palette_of(static_cast<std::uint8_t>(frame))).ok());
  }
  ASSERT_TRUE(chain.wait_until_shown().ok());
  look();
  EXPECT_EQ(chain.counts().shown, appeared.size());
  EXPECT_EQ(chain.counts().shown + chain.counts().dropped, 40U);
  EXPECT_EQ(chain.counts().repeated, appeared.back() - appeared.front() + 1U - appeared.size());
}

TEST_F(Kms, AFlipThatFailsChangesNothing) {
  KmsPanel panel("/dev/dri/card0", {}, kernel_);
  ASSERT_TRUE(panel.show(1, palette_of(5)).ok());
  ASSERT_TRUE(panel.wait_for_vblank().ok());
  fill(panel, 0, 200);
  std::vector<std::uint8_t> colours = palette_of(6);
  std::fill(colours.begin() + 600, colours.begin() + 603, std::uint8_t{9});
  card().flip_error = EBUSY;
  card().flips_left = 0;
  EXPECT_FALSE(panel.show(0, colours).ok());
  EXPECT_FALSE(panel.show_pending());
  EXPECT_EQ(panel.on_display(), 1);
  EXPECT_FALSE(panel.show_replaced());
  card().flip_error = 0;
  ASSERT_TRUE(panel.load_palette({}).ok());
  EXPECT_EQ(card().pixel(0, 0), 0x050505U) << "the picture that wasn't shown, or its colours";
  ASSERT_TRUE(panel.show(0, {}).ok());
  ASSERT_TRUE(panel.wait_for_vblank().ok());
  EXPECT_EQ(card().pixel(0, 0), 0x050505U) << "colours of a request that was refused";
}

TEST_F(Kms, AFlipThatFailsAfterTheOneBeforeIsSaidByTheNextCall) {
  KmsPanel panel("/dev/dri/card0", {}, kernel_);
  card().flip_error = EBUSY;
  card().flips_left = 1;
  ASSERT_TRUE(panel.show(1, palette_of(5)).ok());
  ASSERT_TRUE(panel.show(0, palette_of(6)).ok());
  card().vblank();
  EXPECT_FALSE(panel.show_pending());
  EXPECT_EQ(panel.on_display(), 1);
  card().flip_error = 0;
  EXPECT_EQ(panel.show(0, {}), Status(Error::bus, Part::buffer));
  EXPECT_THAT(panel.fault(), HasSubstr("a page flip failed"));
  ASSERT_TRUE(panel.show(0, {}).ok()) << "it is said once";
  ASSERT_TRUE(panel.wait_for_vblank().ok());
  EXPECT_EQ(card().pixel(0, 0), 0x060606U) << "the colours of the lost one stay";
}

TEST_F(Kms, AFlipThatFailsAfterTheOneBeforeIsSaidByAWaitToo) {
  for (const bool noticed_before : {false, true}) {
    KmsPanel panel("/dev/dri/card0", {}, kernel_);
    card().flip_error = EBUSY;
    card().flips_left = 1;
    ASSERT_TRUE(panel.show(1, palette_of(5)).ok());
    ASSERT_TRUE(panel.show(0, palette_of(6)).ok());
    if (noticed_before) {
      card().vblank();
      EXPECT_FALSE(panel.show_pending());
    }
    EXPECT_EQ(panel.wait_for_vblank(), Status(Error::bus, Part::buffer));
    EXPECT_TRUE(panel.wait_for_vblank().ok()) << "it is said once";
  }
}

TEST_F(Kms, ARequestAfterAFlipThatNoOneAskedForWaitsForNothingElse) {
  KmsPanel panel("/dev/dri/card0", {}, kernel_);
  ASSERT_TRUE(panel.show(1, palette_of(5)).ok());
  card().vblank();
  ASSERT_TRUE(panel.show(0, palette_of(6)).ok());
  card().vblank();
  EXPECT_EQ(card().pixel(0, 0), 0x060606U);
}

TEST_F(Kms, ColoursLoadedReachAllRequestsThatWait) {
  KmsPanel panel("/dev/dri/card0", {}, kernel_);
  ASSERT_TRUE(panel.show(1, palette_of(5)).ok());
  ASSERT_TRUE(panel.show(0, palette_of(6)).ok());
  ASSERT_TRUE(panel.load_palette(palette_of(7)).ok());
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(card().pixel(0, 0), 0x070707U) << i;
    ASSERT_TRUE(panel.wait_for_vblank().ok());
  }
}

TEST_F(Kms, ColoursOfARequestThatIsReplacedReachTheNext) {
  KmsPanel panel("/dev/dri/card0", {}, kernel_);
  fill(panel, 0, 1);
  ASSERT_TRUE(panel.show(1, palette_of(7)).ok());
  ASSERT_TRUE(panel.show(1, palette_of(8)).ok());
  ASSERT_TRUE(panel.show(0, std::vector<std::uint8_t>{1, 1, 1}).ok());
  ASSERT_TRUE(panel.wait_for_vblank().ok());
  ASSERT_TRUE(panel.wait_for_vblank().ok());
  EXPECT_EQ(card().pixel(0, 0), 0x080808U);
}

TEST_F(Kms, ColoursLoadedWhileARequestWaitsDoNotShowItsColoursOrItsPicture) {
  KmsPanel panel("/dev/dri/card0", {}, kernel_);
  fill(panel, 0, 0);
  fill(panel, 1, 1);
  ASSERT_TRUE(panel.show(0, palette_of(5)).ok());
  ASSERT_TRUE(panel.wait_for_vblank().ok());
  ASSERT_TRUE(panel.show(1, palette_of(6)).ok());
  ASSERT_TRUE(panel.load_palette(std::vector<std::uint8_t>{9, 9, 9}).ok());
  EXPECT_EQ(card().pixel(0, 0), 0x090909U) << "entry 0, at once";
  ASSERT_TRUE(panel.load_palette({}).ok());
  EXPECT_EQ(card().pixel(0, 0), 0x090909U);
  ASSERT_TRUE(panel.wait_for_vblank().ok());
  EXPECT_EQ(card().pixel(0, 0), 0x060606U) << "entry 1";
  fill(panel, 0, 0);
  ASSERT_TRUE(panel.show(0, {}).ok());
  ASSERT_TRUE(panel.wait_for_vblank().ok());
  EXPECT_EQ(card().pixel(0, 0), 0x090909U) << "entry 0, later";
}

TEST_F(Kms, ColoursAloneCanBeLoaded) {
  KmsPanel panel("/dev/dri/card0", {}, kernel_);
  ASSERT_TRUE(panel.show(1, palette_of(7)).ok());
  ASSERT_TRUE(panel.wait_for_vblank().ok());
  ASSERT_TRUE(panel.load_palette(palette_of(9)).ok());
  EXPECT_EQ(card().pixel(50, 50), 0x090909U);
}

TEST_F(Kms, VblanksAreWaitedForWithoutAFlipToo) {
  KmsPanel panel("/dev/dri/card0", {}, kernel_);
  const std::uint32_t before = panel.vblank_count();
  ASSERT_TRUE(panel.wait_for_vblank().ok());
  EXPECT_EQ(panel.vblank_count(), before + 1U);
}

TEST_F(Kms, ADriverThatTellsNoVblanksIsStoodInForByATimer) {
  card().tells_vblanks = false;
  KmsPanel panel("/dev/dri/card0", {}, kernel_);
  EXPECT_FALSE(panel.tells_vblanks());
  EXPECT_FALSE(panel.capabilities().vblank_signal);
  const std::uint32_t before = panel.vblank_count();
  ASSERT_TRUE(panel.wait_for_vblank().ok());
  EXPECT_GT(panel.vblank_count(), before);
}

TEST_F(Kms, ADriverThatFlipsAtOnceDoesNotLetTimeRunAway) {
  card().tells_vblanks = false;
  card().flips_at_once = true;
  KmsPanel panel("/dev/dri/card0", {}, kernel_);
  const std::uint32_t before = panel.vblank_count();
  const hal::Nanoseconds began = kernel_.time.now();
  for (int i = 0; i < 60; ++i) {
    ASSERT_TRUE(panel.show(i % 2, {}).ok());
    ASSERT_TRUE(panel.wait_for_vblank().ok());
    ASSERT_FALSE(panel.show_pending());
  }
  EXPECT_EQ(panel.vblank_count() - before, 60U);
  EXPECT_NEAR(static_cast<double>(kernel_.time.now() - began), 1e9, 1e3);
  EXPECT_EQ(panel.flips(), 60U);
}

TEST_F(Kms, TheScreenIsGivenBackAsItWas) {
  for (const std::uint32_t before : {0U, 77U}) {
    card().shown_before = before;
    {
      KmsPanel panel("/dev/dri/card0", {}, kernel_);
      ASSERT_TRUE(panel.show(1, palette_of(7)).ok());
      EXPECT_NE(card().shown, before);
    }
    EXPECT_EQ(card().shown, before);
  }
}

TEST_F(Kms, FaultsNameTheCard) {
  {
    KmsPanel panel("/dev/dri/card0", {}, kernel_);
    card().flip_error = ENODEV;
    card().flips_left = 0;
    EXPECT_EQ(panel.show(1, {}), Status(Error::disconnected, Part::buffer));
    EXPECT_THAT(panel.fault(), AllOf(HasSubstr("graphics card /dev/dri/card0"), HasSubstr("gone")));
  }
  card().flip_error = 0;
  KmsPanel panel("/dev/dri/card0", {}, kernel_);
  card().flips_stick = true;
  ASSERT_TRUE(panel.show(1, {}).ok());
  EXPECT_EQ(panel.wait_for_vblank(), Status(Error::timeout, Part::buffer));
  EXPECT_THAT(panel.fault(), HasSubstr("a page flip didn't happen"));
}

TEST_F(Kms, SignalsDoNotEndAWait) {
  KmsPanel panel("/dev/dri/card0", {}, kernel_);
  ASSERT_TRUE(panel.show(1, palette_of(7)).ok());
  card().signals = 3;
  ASSERT_TRUE(panel.wait_for_vblank().ok());
  EXPECT_FALSE(panel.show_pending());
  EXPECT_EQ(panel.flips(), 1U);
}

TEST_F(Kms, ACountThatFailsForAWhileStandsStill) {
  KmsPanel panel("/dev/dri/card0", {}, kernel_);
  const std::uint32_t before = panel.vblank_count();
  card().vblank_error = EBUSY;
  EXPECT_EQ(panel.vblank_count(), before);
  EXPECT_EQ(panel.wait_for_vblank(), Status(Error::timeout, Part::panel));
  card().vblank_error = EINVAL;
  EXPECT_EQ(panel.wait_for_vblank(), Status(Error::bus, Part::panel));
  EXPECT_THAT(panel.fault(), HasSubstr("waiting for the VBLANK failed"));
}

TEST_F(Kms, TheScreenIsGivenBackWhileFlipsWait) {
  card().shown_before = 77;
  {
    KmsPanel panel("/dev/dri/card0", {}, kernel_);
    ASSERT_TRUE(panel.show(1, palette_of(7)).ok());
    ASSERT_TRUE(panel.show(0, palette_of(8)).ok());
  }
  EXPECT_EQ(card().shown, 77U);
}

TEST_F(Kms, TheEngineIsTheScreensOwnElseOneThatDrivesNoOther) {
  struct Case {
    int driven_by, other_driven_by, wanted;
  };
  card().engines = 3;
  for (const Case& c : {Case{fake_card::none, fake_card::none, 0}, Case{2, 0, 2}, Case{1, fake_card::none, 1},
                        Case{fake_card::none, 0, 1}, Case{fake_card::none, 1, 0}}) {
    card().driven_by = c.driven_by;
    card().other_driven_by = c.other_driven_by;
    const KmsPanel panel("/dev/dri/card0", {}, kernel_);
    EXPECT_EQ(card().engine, c.wanted) << c.driven_by << ' ' << c.other_driven_by;
  }
  card().engines = 1;
  card().driven_by = fake_card::none;
  card().other_driven_by = 0;
  const KmsPanel panel("/dev/dri/card0", {}, kernel_);
  EXPECT_EQ(card().engine, 0) << "there is no other";
}

TEST_F(Kms, RefreshesAreReckonedFromTheMode) {
  const auto refresh = [this] {
    return KmsPanel("/dev/dri/card0", {}, kernel_).capabilities().refresh_millihertz;
  };
  card().refresh = 50;
  EXPECT_EQ(refresh(), 50'000U);
  card().clock = 148'500;
  card().total_width = 2200;
  card().total_height = 1125;
  EXPECT_EQ(refresh(), 60'000U);
  card().clock = 74'250;
  EXPECT_EQ(refresh(), 30'000U);
  card().mode_flags = DRM_MODE_FLAG_INTERLACE;
  EXPECT_EQ(refresh(), 60'000U) << "fields";
  card().mode_flags = DRM_MODE_FLAG_DBLSCAN;
  EXPECT_EQ(refresh(), 15'000U);
  // Numbers that can't be are 60 Hz.
  card().clock = 1;
  EXPECT_EQ(refresh(), 60'000U);
  card().clock = 0;
  for (const std::uint32_t lie : {0U, 1U << 29U, 0xFFFF'FFFFU}) {
    card().refresh = lie;
    EXPECT_EQ(refresh(), 60'000U) << lie;
  }
}

TEST_F(Kms, ADriverThatLiesAboutSizesIsRefused) {
  card().pitch_lie = 399;
  EXPECT_THAT(refusal(), AllOf(HasSubstr("graphics card /dev/dri/card0"), HasSubstr("rows of 399")));
  card().pitch_lie = 1U << 31U;
  EXPECT_THAT(refusal(), HasSubstr("which can't be"));
  card().pitch_lie = 464;
  card().size_lie = 464 * 70 - 1;
  EXPECT_THAT(refusal(), HasSubstr("32479 bytes"));
  card().size_lie = 1ULL << 40U;
  EXPECT_THAT(refusal(), HasSubstr("which can't be"));
  card().pitch_lie = 0;
  card().size_lie = 0;
  card().height = 0;
  EXPECT_THAT(refusal(), HasSubstr("100x0 pixels, which no screen has"));
}

TEST_F(Kms, WhatCanNotBeHadIsSaid) {
  kernel_.open_error = EACCES;
  EXPECT_THAT(refusal(), HasSubstr("graphics card /dev/dri/card0: permission denied; "));
  kernel_.open_error = 0;
  EXPECT_THAT(refusal({101, 70}), HasSubstr("100x70 pixels, too few for 101x70"));
  EXPECT_THAT(refusal({0, 5}), HasSubstr("for 0x5"));
  EXPECT_THAT(refusal({5, -1}), HasSubstr("for 5x-1"));
  card().resources_error = EOPNOTSUPP;
  EXPECT_THAT(refusal(), HasSubstr("/dev/dri/card0 has no screens"));
  card().resources_error = 0;
  card().set_error = EACCES;
  EXPECT_THAT(refusal(), AllOf(HasSubstr("Permission denied"), HasSubstr("a desktop holds it")));
  card().set_error = 0;
  card().has_dumb_buffers = false;
  EXPECT_THAT(refusal(), HasSubstr("no buffers that programs can draw in"));
  card().plugged_in = false;
  EXPECT_THAT(refusal(), HasSubstr("no screen is plugged in"));
}

TEST_F(Kms, ScreensAreListed) {
  EXPECT_THAT(hal::linux_io::kms_screens("/dev/dri/card0", kernel_), testing::ElementsAre("100x70"));
  card().plugged_in = false;
  EXPECT_TRUE(hal::linux_io::kms_screens("/dev/dri/card0", kernel_).empty());
  kernel_.open_error = ENOENT;
  EXPECT_TRUE(hal::linux_io::kms_screens("/dev/dri/card9", kernel_).empty());
}

}  // namespace
