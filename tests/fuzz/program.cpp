// SPDX-License-Identifier: MIT
//
// The drawing language: every text is a picture, or an error that says in which line it is wrong.
#include <host/draw/program.hpp>
#include <host/failure.hpp>
#include <tests/fuzz/input.hpp>

#include <charconv>
#include <string>

namespace fuzz {
namespace {

/// True if the text makes a surface of at most 2^16 pixels (2^12 if it draws smoothly, which asks each edge
/// for each of up to 64 samples), or none: the rest would be a test of memory and patience.
bool is_small(std::string_view text) {
  const auto command = text.find("surface");
  if (command == std::string_view::npos) return true;
  std::int64_t area = 1;
  std::string_view rest = text.substr(command + 7);
  for (int i = 0; i < 2; ++i) {
    while (!rest.empty() && (rest.front() == ' ' || rest.front() == '\t' || rest.front() == '+'))
      rest.remove_prefix(1);
    int side = 0;
    const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), side);
    if (error != std::errc{} || side < 1 || side > 1 << 16) return false;
    rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
    area *= side;
  }
  const int most = text.find("aa") == std::string_view::npos ? 1 << 16 : 1 << 12;
  return area <= most && rest.find("surface") == std::string_view::npos;
}

struct Outcome {
  std::string error;
  std::vector<std::uint8_t> indices;
  std::string printed;
  friend bool operator==(const Outcome&, const Outcome&) = default;
};

Outcome outcome(std::string_view text) {
  try {
    const auto canvas = host::draw::draw_program(text);
    const auto size = canvas->size();
    Outcome result{{}, canvas->indices(), canvas->printed()};
    require(
        result.indices.size() == static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height),
        "not one index a pixel");
    for (const std::uint8_t index : result.indices) require(index <= canvas->max_index(), "no such index");
    return result;
  } catch (const host::Failure& failure) {
    const std::string what = failure.what();
    require(what.starts_with("line "), "an error that doesn't say where: " + what);
    return {what, {}, {}};
  }
}

}  // namespace

void run(Input in) {
  const std::string_view text = in.rest_as_text();
  if (!is_small(text)) return;
  require(outcome(text) == outcome(text), "the same program draws another picture");
}

}  // namespace fuzz
