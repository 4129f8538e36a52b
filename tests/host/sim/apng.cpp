// SPDX-License-Identifier: MIT
//
// Animated PNG: a reader of its own takes the files apart, checks every chunk's CRC bit by bit, plays the
// frames and compares them with what went in.
#include <host/sim/apng.hpp>
#include <tests/host/run_tool.hpp>

#include <gtest/gtest.h>

#include <filesystem>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>
#include <zlib.h>

namespace {

using host::ApngWriter;
using host::RgbPicture;
using Bytes = std::vector<std::uint8_t>;

/// A path that goes away with the object, and is nobody else's.
class TemporaryFile {
 public:
  TemporaryFile() : path_(folder_ / "picture.png") {}
  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] Bytes read() const {
    const std::string bytes = test_host::read(path_);
    return {bytes.begin(), bytes.end()};
  }

 private:
  test_host::Folder folder_;
  std::string path_;
};

std::uint32_t u32(const std::uint8_t* p) {
  return static_cast<std::uint32_t>(p[0]) << 24U | static_cast<std::uint32_t>(p[1]) << 16U |
         static_cast<std::uint32_t>(p[2]) << 8U | p[3];
}

std::uint32_t crc_bit_by_bit(const std::uint8_t* begin, const std::uint8_t* end) {
  std::uint32_t crc = 0xFFFFFFFFU;
  for (; begin != end; ++begin) {
    crc ^= *begin;
    for (int bit = 0; bit < 8; ++bit) crc = (crc & 1U) != 0 ? crc >> 1U ^ 0xEDB88320U : crc >> 1U;
  }
  return ~crc;
}

struct Chunk {
  std::string type;
  Bytes data;
};

/// The chunks of a file; throws if a length, a CRC or the signature is wrong.
std::vector<Chunk> chunks_of(const Bytes& file) {
  const Bytes signature{0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
  if (file.size() < 8 || !std::equal(signature.begin(), signature.end(), file.begin()))
    throw std::runtime_error("signature");
  std::vector<Chunk> chunks;
  std::size_t at = 8;
  while (at < file.size()) {
    if (file.size() - at < 12) throw std::runtime_error("cut off");
    const std::size_t length = u32(&file[at]);
    if (file.size() - at - 12 < length) throw std::runtime_error("length");
    const std::uint8_t* const type = &file[at + 4];
    if (u32(type + 4 + length) != crc_bit_by_bit(type, type + 4 + length)) throw std::runtime_error("crc");
    chunks.push_back({std::string(type, type + 4), Bytes(type + 4, type + 4 + length)});
    at += 12 + length;
  }
  return chunks;
}

struct Animation {
  std::uint32_t stated_frames = 0;
  int frames_per_second = 0;
  std::vector<RgbPicture> frames;
};

/// Plays the subset of the format that the writer uses; throws on anything else.
Animation play(const Bytes& file) {
  const std::vector<Chunk> chunks = chunks_of(file);
  if (chunks.size() < 5 || chunks[0].type != "IHDR" || chunks[1].type != "acTL" ||
      chunks.back().type != "IEND")
    throw std::runtime_error("order of chunks");
  Animation animation;
  RgbPicture canvas(static_cast<int>(u32(chunks[0].data.data())),
                    static_cast<int>(u32(chunks[0].data.data() + 4)));
  animation.stated_frames = u32(chunks[1].data.data());
  std::uint32_t sequence = 0;
  for (std::size_t i = 2; i + 1 < chunks.size(); i += 2) {
    const Bytes& control = chunks[i].data;
    if (chunks[i].type != "fcTL" || u32(control.data()) != sequence++) throw std::runtime_error("fcTL");
    const auto width = static_cast<int>(u32(control.data() + 4));
    const auto height = static_cast<int>(u32(control.data() + 8));
    const auto x = static_cast<int>(u32(control.data() + 12));
    const auto y = static_cast<int>(u32(control.data() + 16));
    if (x + width > canvas.width || y + height > canvas.height) throw std::runtime_error("rectangle");
    animation.frames_per_second = control[22] << 8 | control[23];
    Bytes data = chunks[i + 1].data;
    if (i == 2) {
      if (chunks[i + 1].type != "IDAT") throw std::runtime_error("IDAT");
    } else {
      if (chunks[i + 1].type != "fdAT" || u32(data.data()) != sequence++) throw std::runtime_error("fdAT");
      data.erase(data.begin(), data.begin() + 4);
    }
    const std::size_t row_bytes = 1 + 3 * static_cast<std::size_t>(width);
    Bytes rows(row_bytes * static_cast<std::size_t>(height));
    uLongf size = rows.size();
    if (uncompress(rows.data(), &size, data.data(), data.size()) != Z_OK || size != rows.size())
      throw std::runtime_error("pixels");
    for (int row = 0; row < height; ++row) {
      const std::uint8_t* const from = &rows[static_cast<std::size_t>(row) * row_bytes];
      if (from[0] != 0) throw std::runtime_error("filter");
      std::copy(from + 1, from + row_bytes, canvas.at(x, y + row).data());
    }
    animation.frames.push_back(canvas);
  }
  return animation;
}

RgbPicture noise(int width, int height, std::mt19937& random) {
  RgbPicture picture(width, height);
  for (std::uint8_t& byte : picture.bytes) byte = static_cast<std::uint8_t>(random());
  return picture;
}

TEST(Apng, PlaysBackEveryFrame) {
  std::mt19937 random(7);
  const TemporaryFile file;
  std::vector<RgbPicture> frames{noise(37, 23, random)};
  for (int i = 1; i < 30; ++i) {
    RgbPicture next = frames.back();
    for (std::uint32_t change = random() % 4; change > 0; --change)
      next.at(static_cast<int>(random() % 37), static_cast<int>(random() % 23))[random() % 3] ^= 0x55;
    if (i % 10 == 0) next = noise(37, 23, random);
    frames.push_back(next);
  }
  ApngWriter writer(file.path(), 37, 23, 25);
  for (const RgbPicture& frame : frames) writer.add(frame);
  writer.finish();
  const Animation animation = play(file.read());
  EXPECT_EQ(animation.stated_frames, 30U);
  EXPECT_EQ(animation.frames_per_second, 25);
  EXPECT_EQ(animation.frames, frames);
}

TEST(Apng, AStandingPictureCostsOnlyAPixelAFrame) {
  std::mt19937 random(8);
  const RgbPicture picture = noise(64, 64, random);
  const TemporaryFile one;
  ApngWriter short_writer(one.path(), 64, 64, 60);
  short_writer.add(picture);
  short_writer.finish();
  const TemporaryFile hundred;
  ApngWriter long_writer(hundred.path(), 64, 64, 60);
  for (int i = 0; i < 100; ++i) long_writer.add(picture);
  long_writer.finish();
  EXPECT_EQ(play(hundred.read()).frames, std::vector<RgbPicture>(100, picture));
  EXPECT_LT(hundred.read().size(), one.read().size() + 100U * 100U);
}

TEST(Apng, ReaderSeesADamagedByte) {
  const TemporaryFile file;
  ApngWriter writer(file.path(), 4, 4, 60);
  writer.add(RgbPicture(4, 4));
  writer.finish();
  Bytes bytes = file.read();
  EXPECT_NO_THROW(play(bytes));
  bytes[bytes.size() / 2] ^= 1U;
  EXPECT_THROW(play(bytes), std::runtime_error);
}

TEST(Apng, AnUnfinishedFileGoesAway) {
  const TemporaryFile file;
  {
    ApngWriter writer(file.path(), 4, 4, 60);
    writer.add(RgbPicture(4, 4));
  }
  EXPECT_FALSE(std::filesystem::exists(file.path()));
}

TEST(Apng, RefusesWhatItCannotDo) {
  EXPECT_THROW(ApngWriter("/no/such/folder/x.png", 4, 4, 60), std::runtime_error);
  const TemporaryFile file;
  ApngWriter writer(file.path(), 4, 4, 60);
  EXPECT_THROW(writer.finish(), std::runtime_error);
  EXPECT_THROW(writer.add(RgbPicture(5, 4)), std::runtime_error);
}

}  // namespace
