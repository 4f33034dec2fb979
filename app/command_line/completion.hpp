#pragma once

#include <string>

#include "striate/app/command_line/command_text.hpp"

namespace striate::app {

/// A script that bash sources: completes commands, options, files, and the values of options that
/// have a closed set. It needs no bash-completion package.
[[nodiscard]] std::string bash_completion(const CommandText& striate);

/// The same for zsh: the file `_striate` in a folder of `fpath`, or to be sourced after compinit.
[[nodiscard]] std::string zsh_completion(const CommandText& striate);

}  // namespace striate::app
