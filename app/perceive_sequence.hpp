#pragma once

#include <filesystem>
#include <functional>

#include "striate/app/perceive_options.hpp"
#include "striate/platform/datasets/sequences/sequence.hpp"

namespace striate::app {

/// What `striate perceive` is asked of many pictures.
struct PerceiveSequenceOptions {
  std::filesystem::path source;  ///< folder, video, sequence or picture
  datasets::SequenceOptions sequence;
  PerceiveOptions frame;          ///< without left and right; `out` empty: no files are written
  bool json = false;              ///< a JSON object a line, the last one of all frames
  std::function<bool()> stopped;  ///< asked before each frame; empty: never
};

/// Sees every frame that is asked for, prints a line for each and one for all. Files are numbered:
/// overview_000012.png. Memory holds one pair, whatever the length.
/// @return 0; 1 where no frame could be seen; 130 where it was stopped
int perceive_sequence(const PerceiveSequenceOptions& options);

/// Says on standard error what sort of sequence it is and what is odd about it.
void tell_sequence(const datasets::Sequence& sequence);
/// The same of what came up while it was read. @param told remarks that were said before
void tell_left_out(const datasets::Sequence& sequence, std::size_t told);

}  // namespace striate::app
