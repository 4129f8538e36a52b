// SPDX-License-Identifier: MIT
#include <host/failure.hpp>
#include <host/sim/apng.hpp>

#include <algorithm>
#include <array>
#include <filesystem>
#include <system_error>
#include <zlib.h>

namespace host {

namespace {

using Bytes = std::vector<std::uint8_t>;

void append_u32(Bytes& out, std::uint32_t value) {
  for (const unsigned shift : {24U, 16U, 8U, 0U}) out.push_back(static_cast<std::uint8_t>(value >> shift));
}

void append_u16(Bytes& out, unsigned value) {
  out.push_back(static_cast<std::uint8_t>(value >> 8U));
  out.push_back(static_cast<std::uint8_t>(value));
}

void append_side(Bytes& out, int value) { append_u32(out, static_cast<std::uint32_t>(value)); }

void write_bytes(std::ofstream& file, std::span<const std::uint8_t> bytes) {
  file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

/// The rows of a rectangle, each behind its filter byte (0, none: drawings are flat), deflated onto `out`.
void append_deflated(Bytes& out, const RgbPicture& picture, int x, int y, int width, int height) {
  Bytes rows;
  rows.reserve(static_cast<std::size_t>(height) * (3 * static_cast<std::size_t>(width) + 1));
  for (int row = y; row < y + height; ++row) {
    const auto* const first = picture.at(x, row).data();
    rows.push_back(0);
    rows.insert(rows.end(), first, first + std::size_t{3} * static_cast<std::size_t>(width));
  }
  uLongf size = compressBound(rows.size());
  const std::size_t begin = out.size();
  out.resize(begin + size);
  if (compress2(out.data() + begin, &size, rows.data(), rows.size(), Z_DEFAULT_COMPRESSION) != Z_OK)
    throw Failure("out of memory while compressing a picture");
  out.resize(begin + size);
}

}  // namespace

ApngWriter::ApngWriter(const std::string& path, int width, int height, int frames_per_second)
    : path_(path),
      file_(path, std::ios::binary | std::ios::trunc),
      frames_per_second_(frames_per_second),
      last_(width, height) {
  if (!file_) throw Failure("cannot write " + path);
  constexpr std::array<std::uint8_t, 8> signature{0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
  write_bytes(file_, signature);
  Bytes header;
  append_side(header, width);
  append_side(header, height);
  header.insert(header.end(), {8, 2, 0, 0, 0});  // 8 bits a channel, RGB, deflate, filters, not interlaced
  write_chunk("IHDR", header);
  animation_control_ = file_.tellp();
  write_animation_control();
}

ApngWriter::~ApngWriter() {
  std::error_code ignored;
  if (!finished_ && std::filesystem::is_regular_file(path_, ignored)) std::filesystem::remove(path_, ignored);
}

void ApngWriter::add(const RgbPicture& picture) {
  if (picture.width != last_.width || picture.height != last_.height ||
      picture.bytes.size() != last_.bytes.size())
    throw Failure("a frame of another size than the animation " + path_);
  const Area area = frames_ == 0 ? Area{0, 0, picture.width, picture.height} : changed(picture);
  Bytes control;
  append_u32(control, sequence_++);
  append_side(control, area.width);
  append_side(control, area.height);
  append_side(control, area.x);
  append_side(control, area.y);
  append_u16(control, 1);  // it stands for 1 / frames_per_second
  append_u16(control, static_cast<unsigned>(frames_per_second_));
  control.insert(control.end(), {0, 0});  // what is there stays, and the rectangle replaces it
  write_chunk("fcTL", control);
  Bytes data;
  if (frames_ != 0) append_u32(data, sequence_++);
  append_deflated(data, picture, area.x, area.y, area.width, area.height);
  if (frames_ == 0)
    write_chunk("IDAT", data);
  else
    write_chunk("fdAT", data);
  ++frames_;
  last_ = picture;
}

void ApngWriter::finish() {
  if (frames_ == 0) throw Failure("an animation without a frame: " + path_);
  write_chunk("IEND", {});
  file_.seekp(animation_control_);
  write_animation_control();
  file_.close();
  if (!file_) throw Failure("cannot write " + path_);
  finished_ = true;
}

/// The smallest rectangle with all pixels that differ from the last frame; one pixel if none does, for a
/// frame can't be empty.
ApngWriter::Area ApngWriter::changed(const RgbPicture& picture) const {
  int left = picture.width;
  int top = picture.height;
  int right = 0;
  int bottom = 0;
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      if (std::ranges::equal(picture.at(x, y), last_.at(x, y))) continue;
      left = std::min(left, x);
      right = std::max(right, x + 1);
      top = std::min(top, y);
      bottom = y + 1;
    }
  }
  if (right == 0) return {0, 0, 1, 1};
  return {left, top, right - left, bottom - top};
}

void ApngWriter::write_chunk(const char (&type)[5], std::span<const std::uint8_t> data) {
  Bytes chunk;
  append_u32(chunk, static_cast<std::uint32_t>(data.size()));
  chunk.insert(chunk.end(), type, type + 4);
  chunk.insert(chunk.end(), data.begin(), data.end());
  append_u32(chunk, static_cast<std::uint32_t>(
                        crc32(0, chunk.data() + 4, static_cast<uInt>(chunk.size() - 4))));  // not the length
  write_bytes(file_, chunk);
  if (!file_) throw Failure("cannot write " + path_);
}

void ApngWriter::write_animation_control() {
  Bytes control;
  append_u32(control, frames_);
  append_u32(control, 0);  // plays for ever
  write_chunk("acTL", control);
}

}  // namespace host
