// SPDX-License-Identifier: MIT
#include <host/sim/options.hpp>

#include <gtest/gtest.h>

#include <initializer_list>
#include <vector>

namespace {

using host::Options;

std::variant<Options, int> parse(std::initializer_list<const char*> words) {
  std::vector<const char*> argv{"intaglio-sim"};
  argv.insert(argv.end(), words);
  return host::parse_command_line(static_cast<int>(argv.size()), argv.data());
}

TEST(SimOptions, ProgramAloneHasDefaults) {
  const auto parsed = parse({"gauges"});
  ASSERT_TRUE(std::holds_alternative<Options>(parsed));
  const Options& options = std::get<Options>(parsed);
  EXPECT_EQ(options.program, "gauges");
  EXPECT_EQ(options.panel, "clcd");
  EXPECT_FALSE(options.frames.has_value());
  EXPECT_EQ(options.frames_per_second, 60);
}

TEST(SimOptions, BadOnesEndWithAnErrorCode) {
  for (const std::initializer_list<const char*> words : {
           std::initializer_list<const char*>{},
           {"gauges", "--frames", "-1"},
           {"gauges", "--frames", "0"},
           {"gauges", "--frames", "many"},
           {"gauges", "--fps", "0"},
           {"gauges", "--scale", "0"},
           {"gauges", "--nonsense"},
           {"gauges", "map"},
           {"gauges", "--window", "--terminal"},
           {"gauges", "--digest", "--terminal"},
       }) {
    const auto parsed = parse(words);
    ASSERT_TRUE(std::holds_alternative<int>(parsed));
    EXPECT_NE(std::get<int>(parsed), 0);
  }
}

TEST(SimOptions, HelpIsNoError) {
  const auto parsed = parse({"--help"});
  ASSERT_TRUE(std::holds_alternative<int>(parsed));
  EXPECT_EQ(std::get<int>(parsed), 0);
}

}  // namespace
