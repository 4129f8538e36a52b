// SPDX-License-Identifier: MIT
#include <hal/hid/crc32.hpp>
#include <hal/hid/device/device.hpp>
#include <hal/hid/protocol.hpp>
#include <hal/hid/run_length.hpp>
#include <hal/mock/strict_panel.hpp>

#include <gtest/gtest.h>

#include <random>
#include <string_view>
#include <vector>

namespace {

using namespace hal::hid;
using hal::Rect;
using Bytes = std::vector<std::uint8_t>;

TEST(HidProtocol, ChecksumHasTheCheckValue) {
  constexpr std::string_view digits = "123456789";
  Crc32 crc;
  for (const char c : digits) crc.add(std::array<std::uint8_t, 1>{static_cast<std::uint8_t>(c)});
  EXPECT_EQ(crc.value(), 0xCBF43926U);
}

TEST(HidProtocol, DescriptorIsWellFormedAndSaysTheSizes) {
  // Items: the low two bits of the prefix tell how many bytes follow.
  const auto descriptor = report_descriptor(1024);
  std::vector<std::pair<unsigned, unsigned>> items;
  for (std::size_t i = 0; i < descriptor.size();) {
    const unsigned size = descriptor[i] & 3U;
    unsigned value = 0;
    ASSERT_LE(i + size, descriptor.size() - 1);
    for (unsigned k = 0; k < size; ++k) value |= static_cast<unsigned>(descriptor[i + 1 + k]) << (8U * k);
    items.emplace_back(descriptor[i] & 0xFCU, value);
    i += 1 + size;
  }
  unsigned count = 0;
  std::vector<unsigned> input_output_feature;
  for (const auto& [item, value] : items) {
    if (item == 0x94) count = value;
    if (item == 0x80 || item == 0x90 || item == 0xB0) input_output_feature.push_back(count);
  }
  EXPECT_EQ(input_output_feature, (std::vector<unsigned>{1024, 1024, 64}));
  EXPECT_EQ(items.front(), (std::pair<unsigned, unsigned>{0x04, usage_page}));
  EXPECT_EQ(items.back().first, 0xC0U);
}

TEST(HidProtocol, ReportsAreCutToTheirLength) {
  Bytes report(64, 0xEE);
  const Bytes payload{1, 2, 3};
  compose(report, {ReportType::pixels, 9, 0x1234, payload});
  EXPECT_EQ(Bytes(report.begin(), report.begin() + 10), (Bytes{0x12, 9, 0x34, 0x12, 3, 0, 1, 2, 3, 0}));
  const auto back = parse(report);
  ASSERT_TRUE(back);
  EXPECT_EQ(Bytes(back->payload.begin(), back->payload.end()), payload);
  report[4] = 59;
  EXPECT_FALSE(parse(report));
  report[4] = 58;
  EXPECT_TRUE(parse(report));
  EXPECT_FALSE(parse(std::span(report).first(5)));
  EXPECT_FALSE(parse({}));
}

TEST(HidProtocol, EverythingComesBackAsItWas) {
  DeviceInfo info;
  info.nonce = 0x01020304;
  info.report_bytes = 512;
  info.window = 5;
  info.has_keys = true;
  info.capabilities = {.width = 320,
                       .height = 4096,
                       .bits_per_pixel = 4,
                       .bit_order = hal::BitOrder::lsb_first,
                       .palette_entries = 16,
                       .palette_bits = 6,
                       .scan = hal::ScanDirection::left,
                       .vblank_signal = true,
                       .refresh_millihertz = 59'940};
  const auto bytes = encode(info);
  const auto back = decode_info(bytes);
  ASSERT_TRUE(back);
  EXPECT_EQ(encode(*back), bytes);
  EXPECT_EQ(back->capabilities.refresh_millihertz, 59'940U);

  DeviceState state{.next = 7,
                    .gap = true,
                    .panel_failed = true,
                    .verdict = Verdict::mismatch,
                    .decided = 3,
                    .shown = 2,
                    .vblanks = 0xFFFFFFF0,
                    .keys = 0x21};
  const auto packed = encode(state);
  const auto got = decode_state({ReportType::status, 1, 7, packed});
  ASSERT_TRUE(got);
  EXPECT_EQ(encode(*got), packed);
  EXPECT_EQ(got->next, 7);

  const auto hello = decode_hello(encode(Hello{0xABCD01, false}));
  ASSERT_TRUE(hello);
  EXPECT_EQ(hello->nonce, 0xABCD01U);
  EXPECT_FALSE(hello->tell_vblank);
  EXPECT_EQ(decode_rect(encode(Rect{1, 2, 3, 4})), (Rect{1, 2, 3, 4}));
  const auto commit = decode_commit(encode(Commit{9, 0xDEADBEEF}));
  ASSERT_TRUE(commit);
  EXPECT_EQ(commit->checksum, 0xDEADBEEFU);
}

TEST(HidProtocol, BytesAreWhereTheDocumentSays) {
  const auto all = [](auto bytes) { return Bytes(bytes.begin(), bytes.end()); };
  EXPECT_EQ(all(encode(Hello{0x44332211, true})),
            (Bytes{'I', 'T', 'G', 'L', 1, 0, 0x11, 0x22, 0x33, 0x44, 0x01}));
  EXPECT_EQ(all(encode(Hello{0x44332211, false})).back(), 0x00);
  DeviceInfo info{.nonce = 0x44332211, .report_bytes = 0x0200, .window = 7, .has_keys = true};
  info.capabilities = {.width = 0x0102,
                       .height = 0x0304,
                       .bits_per_pixel = 4,
                       .bit_order = hal::BitOrder::lsb_first,
                       .palette_entries = 16,
                       .palette_bits = 6,
                       .scan = hal::ScanDirection::left,
                       .vblank_signal = true,
                       .refresh_millihertz = 0x0A0B0C0D};
  EXPECT_EQ(all(encode(info)),
            (Bytes{'I',   'T', 'G', 'L', 1,  0, 0x11, 0x22, 0x33, 0x44, 0x00, 0x02, 7, 0x07, 0x02, 0x01,
                   4 - 0, 3,   4,   3,   16, 0, 6,    0,    0x0D, 0x0C, 0x0B, 0x0A, 0, 0,    0,    0}));
  const DeviceState state{.next = 9,
                          .gap = true,
                          .panel_failed = true,
                          .verdict = Verdict::mismatch,
                          .decided = 0x0102,
                          .shown = 0x0304,
                          .vblanks = 0x0A0B0C0D,
                          .keys = 0x0021};
  EXPECT_EQ(all(encode(state)), (Bytes{0x05, 3, 0x02, 0x01, 0x04, 0x03, 0x0D, 0x0C, 0x0B, 0x0A, 0x21, 0}));
  EXPECT_EQ(all(encode(DeviceState{.no_session = true})), (Bytes{2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}));
  EXPECT_EQ(all(encode(Rect{0x0102, 0x0304, 0x0506, 0x0708})), (Bytes{2, 1, 4, 3, 6, 5, 8, 7}));
  EXPECT_EQ(all(encode(Commit{0x0102, 0x0A0B0C0D})), (Bytes{2, 1, 0x0D, 0x0C, 0x0B, 0x0A}));
  // The tokens, each at its ends.
  const auto token = [](const Bytes& bytes) {
    std::span<const std::uint8_t> rest(bytes);
    const auto t = take_token(rest);
    return t ? std::pair(t->kind, t->count) : std::pair(Token::Kind::skip, std::size_t{0});
  };
  using Kind = Token::Kind;
  EXPECT_EQ(token({0x00, 9}), (std::pair(Kind::literal, std::size_t{1})));
  EXPECT_EQ(token(Bytes(200, 0x7F)), (std::pair(Kind::literal, std::size_t{128})));
  EXPECT_EQ(token({0x80, 9}), (std::pair(Kind::run, std::size_t{2})));
  EXPECT_EQ(token({0xBF, 9}), (std::pair(Kind::run, std::size_t{65})));
  EXPECT_EQ(token({0xC0}), (std::pair(Kind::skip, std::size_t{1})));
  EXPECT_EQ(token({0xFD}), (std::pair(Kind::skip, std::size_t{62})));
  EXPECT_EQ(token({0xFE, 2, 1, 9}), (std::pair(Kind::run, std::size_t{258})));
  EXPECT_EQ(token({0xFF, 2, 1}), (std::pair(Kind::skip, std::size_t{258})));
}

TEST(HidProtocol, NothingImpossibleIsDecoded) {
  DeviceInfo good;
  good.capabilities = hal::mock::write_panel(8, 8, 8);
  const auto bytes = encode(good);
  ASSERT_TRUE(decode_info(bytes));
  const auto with = [&](std::size_t at, std::uint8_t value) {
    auto changed = bytes;
    changed[at] = value;
    return decode_info(changed).has_value();
  };
  EXPECT_FALSE(with(0, 'X'));
  EXPECT_FALSE(with(4, 2)) << "another major version";
  EXPECT_TRUE(with(5, 9)) << "a later minor version";
  EXPECT_FALSE(with(10, 63)) << "short reports";
  EXPECT_FALSE(with(11, 16)) << "long reports";
  EXPECT_FALSE(with(12, 0)) << "no report on the way";
  EXPECT_FALSE(with(12, 17)) << "too many on the way";
  EXPECT_FALSE(with(14, 0)) << "no width";
  EXPECT_FALSE(with(15, 0x11)) << "too wide";
  EXPECT_FALSE(with(16, 0)) << "no height";
  EXPECT_FALSE(with(18, 3)) << "bits a pixel";
  EXPECT_FALSE(with(19, 4)) << "scan direction";
  EXPECT_FALSE(with(21, 2)) << "more colours than indices";
  EXPECT_FALSE(with(22, 0)) << "no bits a colour";
  auto slow = bytes;
  for (std::size_t i = 24; i < 28; ++i) slow[i] = 0;
  slow[24] = 100;
  EXPECT_TRUE(decode_info(slow)) << "a frame in 10 seconds";
  slow[24] = 99;
  EXPECT_FALSE(decode_info(slow)) << "a VBLANK for which nobody waits";
  EXPECT_FALSE(decode_info(std::span(bytes).first(bytes.size() - 1)));
  EXPECT_FALSE(decode_hello(encode(Hello{0x100, true}))) << "a mark of 0";
  EXPECT_FALSE(decode_commit(encode(Commit{0, 1})));
  EXPECT_FALSE(decode_palette(Bytes{0}));
  EXPECT_FALSE(decode_palette(Bytes{0, 1, 2}));
  EXPECT_FALSE(decode_palette(Bytes{255, 1, 2, 3, 4, 5, 6}));
  EXPECT_TRUE(decode_palette(Bytes{255, 1, 2, 3}));
}

/// Covers `held` with tokens, as a device does.
Bytes unpacked(std::span<const std::uint8_t> tokens, Bytes held, std::size_t& at) {
  while (!tokens.empty()) {
    const auto token = take_token(tokens);
    if (!token) ADD_FAILURE() << "a token that isn't whole";
    if (!token || token->count > held.size() - at) return held;
    for (std::size_t i = 0; i < token->count; ++i, ++at)
      if (token->kind != Token::Kind::skip)
        held[at] = token->kind == Token::Kind::run ? token->bytes[0] : token->bytes[i];
  }
  return held;
}

TEST(HidRunLength, WhatIsPackedComesOutAgain) {
  std::mt19937 random(5);
  for (int round = 0; round < 400; ++round) {
    const std::size_t size = 1 + random() % 700U;
    Bytes before(size);
    for (auto& byte : before) byte = static_cast<std::uint8_t>(random() % 3U);
    Bytes fresh = before;
    for (std::size_t i = 0; i < size;) {
      const std::size_t count = std::min<std::size_t>(1 + random() % 90U, size - i);
      const auto kind = random() % 3U;
      for (std::size_t k = 0; k < count; ++k)
        if (kind == 1)
          fresh[i + k] = 7;
        else if (kind == 2)
          fresh[i + k] = static_cast<std::uint8_t>(random());
      i += count;
    }
    const bool known = round % 2 == 0;
    const std::size_t room = 4 + random() % 60U;
    Bytes held = known ? before : Bytes(size, 0x55);
    std::size_t at = 0;
    for (std::size_t taken = 0; taken < size;) {
      Bytes tokens(room);
      const Packed packed =
          pack(std::span(fresh).subspan(taken),
               known ? std::span(before).subspan(taken) : std::span<std::uint8_t>{}, tokens);
      ASSERT_GT(packed.taken, 0U);
      ASSERT_LE(packed.written, room);
      held = unpacked(std::span(tokens).first(packed.written), held, at);
      taken += packed.taken;
      ASSERT_EQ(at, taken);
    }
    ASSERT_EQ(held, fresh) << "round " << round;
  }
}

TEST(HidRunLength, PacksWhatIsAlikeAndCostsLittleWhereNothingIs) {
  Bytes tokens(2000);
  EXPECT_EQ(pack(Bytes(1000, 3), {}, tokens).written, 4U);
  EXPECT_EQ(pack(Bytes(1000, 3), Bytes(1000, 3), tokens).written, 3U);
  EXPECT_EQ(pack(Bytes(60, 3), Bytes(60, 3), tokens).written, 1U);
  Bytes noise(1280);
  for (std::size_t i = 0; i < noise.size(); ++i) noise[i] = static_cast<std::uint8_t>(i * 29U);
  EXPECT_EQ(pack(noise, {}, tokens).written, 1290U);
}

TEST(HidRunLength, ClearsAPatternWithOneRun) {
  // Every eighth byte differs from what is held: short skips would cost more, and looking for runs again and
  // again the square of the size.
  constexpr std::size_t size = 60'000;
  Bytes held(size);
  for (std::size_t i = 7; i < size; i += 8) held[i] = 7;
  Bytes tokens(size);
  const Packed packed = pack(Bytes(size), held, tokens);
  EXPECT_EQ(packed.taken, size);
  EXPECT_EQ(packed.written, 4U);
}

TEST(HidRunLength, HalfTokensAndEmptyOnesAreRefused) {
  const auto whole = [](const Bytes& bytes) {
    std::span<const std::uint8_t> tokens(bytes);
    return take_token(tokens).has_value();
  };
  EXPECT_FALSE(whole({}));
  EXPECT_FALSE(whole({0x01, 5}));
  EXPECT_TRUE(whole({0x01, 5, 6}));
  EXPECT_FALSE(whole({0x80}));
  EXPECT_TRUE(whole({0xC0}));
  EXPECT_FALSE(whole({0xFE, 1, 0}));
  EXPECT_FALSE(whole({0xFE, 0, 0, 1}));
  EXPECT_FALSE(whole({0xFF, 1}));
  EXPECT_FALSE(whole({0xFF, 0, 0}));
  EXPECT_TRUE(whole({0xFF, 0, 1}));
}

}  // namespace
