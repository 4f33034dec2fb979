#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "striate/platform/datasets/sequences/sequence.hpp"

namespace striate::app {

/// What a person says of a sequence of pictures, on the command line of any command that takes one.
struct SequenceArguments {
  datasets::SequenceOptions options;
  std::string from;  ///< "12" or "3.5 s"
  std::string to;

  /// With the places read. @throws UserError for what is neither a number nor a time
  [[nodiscard]] datasets::SequenceOptions read() const;
};

/// --calibration, --side-by-side, --swap, --every, --from, --to
void add_sequence_options(CLI::App& command, SequenceArguments& given);

/// "12": the pair of that number; "3.5 s": so long after the beginning. @param option for messages
[[nodiscard]] datasets::SequencePlace sequence_place(const std::string& option,
                                                     const std::string& text);

}  // namespace striate::app
