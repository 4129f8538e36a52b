// SPDX-License-Identifier: MIT
//
// The example of PROTOCOL.md is what is really sent.
#include <tests/hal/hid/wire.hpp>

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>

namespace {

using hal::hid::Device;
using tests::hid::Bytes;

const char* name_of(std::uint8_t type) {
  switch (static_cast<hal::hid::ReportType>(type)) {
    case hal::hid::ReportType::hello:
      return "HELLO       ";
    case hal::hid::ReportType::palette:
      return "PALETTE     ";
    case hal::hid::ReportType::rectangle:
      return "RECTANGLE   ";
    case hal::hid::ReportType::commit:
      return "COMMIT      ";
    case hal::hid::ReportType::capabilities:
      return "CAPABILITIES";
    case hal::hid::ReportType::status:
      return "STATUS      ";
    default:
      return "?           ";
  }
}

TEST(HidProtocol, TheExampleInTheDocumentIsWhatIsSent) {
  hal::sim::VirtualClock clock;
  hal::sim::PanelSpec spec = hal::sim::paletted(8, 2, 8);
  spec.capabilities.palette_entries = 2;
  hal::sim::Panel glass(spec, clock);
  Device device(glass, nullptr, {});
  tests::hid::Wire wire(clock, device);
  std::ostringstream text;
  const auto record = [&text](const char* way, const Bytes& report) {
    std::size_t end = report.size();
    while (end > hal::hid::header_bytes && report[end - 1] == 0) --end;
    text << way << ' ' << name_of(report[0]);
    for (std::size_t i = 0; i < end; ++i) {
      constexpr char digits[] = "0123456789abcdef";
      text << (i == hal::hid::header_bytes ? "  " : " ") << digits[report[i] >> 4U]
           << digits[report[i] & 15U];
    }
    text << '\n';
  };
  wire.witness = [&](const Bytes& report) { record(">", report); };
  wire.answers = [&](const Bytes& report) { record("<", report); };
  clock.advance(1024U * 0x41424300U);  // a nonce that can be read
  hal::hid::Link link(wire, clock);
  ASSERT_TRUE(link.open().ok());
  hal::hid::HidPanel panel(link);
  const auto buffer = panel.buffer(0);
  std::fill(buffer.begin(), buffer.end(), std::uint8_t{1});
  buffer[11] = 0;
  const Bytes colours{0, 0, 0, 255, 160, 0};
  ASSERT_TRUE(panel.show(0, colours).ok());
  ASSERT_TRUE(panel.wait_for_vblank().ok());
  buffer[11] = 1;
  ASSERT_TRUE(panel.show(0, {}).ok());
  ASSERT_TRUE(panel.wait_for_vblank().ok());

  std::ifstream file(INTAGLIO_SOURCE "/hal/hid/PROTOCOL.md");
  std::ostringstream document;
  document << file.rdbuf();
  EXPECT_NE(document.str().find("<!-- example -->\n```\n" + text.str() + "```\n"), std::string::npos)
      << "the example should be:\n"
      << text.str();
}

}  // namespace
