// SPDX-License-Identifier: MIT
//
// Without libgpiod there is no chip: opening one says that it isn't supported.
#include <hal/linux/gpiod.hpp>

#include <cerrno>

namespace hal::linux_io::gpiod {

struct Chip::Handle {};
struct Request::Handle {};

std::optional<Chip> Chip::open(const std::string&) {
  errno = EOPNOTSUPP;
  return std::nullopt;
}

Chip::Chip(std::unique_ptr<Handle> handle) noexcept : handle_(std::move(handle)) {}
Chip::Chip(Chip&&) noexcept = default;
Chip::~Chip() = default;
std::string Chip::label() const { return {}; }
unsigned Chip::line_count() const { return 0; }
std::optional<unsigned> Chip::find(const std::string&) const { return std::nullopt; }
std::string Chip::name_of(unsigned) const { return {}; }
std::string Chip::consumer_of(unsigned) const { return {}; }
std::optional<Request> Chip::request_outputs(std::span<const unsigned>, unsigned) { return std::nullopt; }
std::optional<Request> Chip::request_edges(unsigned) { return std::nullopt; }
Request::Request(std::unique_ptr<Handle> handle) noexcept : handle_(std::move(handle)) {}
Request::Request(Request&&) noexcept = default;
Request::~Request() = default;
bool Request::set(unsigned) noexcept { return false; }
int Request::wait(std::int64_t) noexcept { return -1; }
int Request::read(std::span<Nanoseconds, queued_edges>) noexcept { return -1; }

}  // namespace hal::linux_io::gpiod
