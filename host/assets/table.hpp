// SPDX-License-Identifier: MIT
//
// Writing C++ tables: the head comment, arrays of numbers.
#pragma once

#include <host/assets/commands.hpp>

#include <functional>
#include <string>
#include <string_view>

namespace host::assets {

/// The head of a generated header: what made it, from what, whose it is; `notes` are further lines.
std::string head_comment(const Heading& heading, std::string_view kind, std::string_view notes = {});

/// `inline constexpr TYPE NAME[] = {…};` of `count` elements, as many to a line as fit.
std::string array(std::string_view type, std::string_view name, std::size_t count,
                  const std::function<std::string(std::size_t)>& element);

/// Throws Failure unless `name` can be the name of a variable, or, with `nested`, of a namespace (`a::b`).
void check_identifier(std::string_view option, std::string_view name, bool nested = false);

/// The last part of a path, which is what a header that must not depend on the machine may name.
std::string file_name(const std::string& path);

}  // namespace host::assets
