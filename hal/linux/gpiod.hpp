// SPDX-License-Identifier: MIT
//
// What is used of libgpiod, the same over both of its interfaces, 1.x (gpiod_1.cpp) and 2.x (gpiod_2.cpp);
// the build takes the one whose header it finds, or gpiod_none.cpp.
//
// Rule: as in libgpiod, a call that fails says why in `errno`.
#pragma once

#include <hal/clock.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>

namespace hal::linux_io::gpiod {

/// The name under which lines are held.
inline constexpr const char* consumer = "intaglio";

/// Most lines of a request.
inline constexpr std::size_t most_lines = 8;

/// Edges that the kernel keeps for a reader who comes late; those beyond are lost.
inline constexpr std::size_t queued_edges = 16;

/// Lines held by this program, until it dies.
class Request {
 public:
  struct Handle;
  explicit Request(std::unique_ptr<Handle> handle) noexcept;
  Request(Request&&) noexcept;
  Request& operator=(Request&&) = delete;
  ~Request();

  /// Drives the lines of a request for output, bit i of `values` the i-th. False: errno.
  bool set(unsigned values) noexcept;
  /// Waits for an edge. 1: there is one, 0: none in time, -1: errno.
  int wait(std::int64_t nanoseconds) noexcept;
  /// Reads edges that have come, as many as there is room for: how many, or -1: errno.
  int read(std::span<Nanoseconds, queued_edges> times) noexcept;

 private:
  std::unique_ptr<Handle> handle_;
};

class Chip {
 public:
  struct Handle;
  /// Nothing: errno.
  static std::optional<Chip> open(const std::string& path);
  explicit Chip(std::unique_ptr<Handle> handle) noexcept;
  Chip(Chip&&) noexcept;
  Chip& operator=(Chip&&) = delete;
  ~Chip();

  [[nodiscard]] std::string label() const;
  [[nodiscard]] unsigned line_count() const;
  /// The number of the line of that name; nothing if none has it.
  [[nodiscard]] std::optional<unsigned> find(const std::string& name) const;
  /// The name of a line, "" if it has none.
  [[nodiscard]] std::string name_of(unsigned line) const;
  /// Who holds a line, "" if that isn't known.
  [[nodiscard]] std::string consumer_of(unsigned line) const;

  /// Takes lines for output, bit i of `values` for the i-th; 1 .. `most_lines` of them. Nothing: errno.
  [[nodiscard]] std::optional<Request> request_outputs(std::span<const unsigned> lines, unsigned values);
  /// Takes a line to watch for rising edges. Nothing: errno.
  [[nodiscard]] std::optional<Request> request_edges(unsigned line);

 private:
  std::shared_ptr<Handle> handle_;
};

}  // namespace hal::linux_io::gpiod
