#pragma once

#include <cstdio>
#include <string_view>

/// Telling a person something where a failure to do so must be none of what is going on: a robot
/// drives on though its log is full. (fmt::print throws where it cannot write.)
namespace striate {

/// Writes the text and flushes. Waits as long as the other end takes. @return whether it was taken
bool say(std::FILE* to, std::string_view text) noexcept;

/// The same for loops that must not wait: a terminal that is held by Ctrl-S or a pipe that nobody
/// empties gets nothing, and that is no failure. @return false where the text cannot be written
bool say_without_waiting(std::FILE* to, std::string_view text) noexcept;

}  // namespace striate
