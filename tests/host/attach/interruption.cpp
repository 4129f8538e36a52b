// SPDX-License-Identifier: MIT
//
// Signals, to which this test program would otherwise fall.
#include <host/attach/interruption.hpp>

#include <gtest/gtest.h>

#include <cerrno>
#include <csignal>
#include <unistd.h>

namespace {

TEST(Interruption, SignalsLeaveAProgramThatDrivesAPanelAlive) {
  host::watch_for_interruption(host::SecondSignal::waits);
  EXPECT_FALSE(host::interrupted());
  for (const int signal : {SIGINT, SIGINT, SIGTERM, SIGHUP, SIGQUIT}) {
    ASSERT_EQ(std::raise(signal), 0);
    EXPECT_TRUE(host::interrupted());
  }
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  close(ends[0]);
  EXPECT_EQ(write(ends[1], "x", 1), -1);
  EXPECT_EQ(errno, EPIPE);
  close(ends[1]);
}

TEST(InterruptionDeathTest, ElseTheSecondOneEndsIt) {
  EXPECT_EXIT(
      {
        host::watch_for_interruption(host::SecondSignal::ends_at_once);
        std::raise(SIGTERM);
        std::raise(SIGTERM);
      },
      testing::KilledBySignal(SIGTERM), "");
}

}  // namespace
