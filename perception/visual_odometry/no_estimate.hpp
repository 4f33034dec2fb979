#pragma once

namespace striate::perception {

/// Why there is no estimate.
enum class NoEstimate {
  none,                ///< there is one
  beginning,           ///< the first view that both eyes see enough of: the world begins here
  too_little_texture,  ///< dark, blank or out of focus: too few places with contrast
  eyes_disagree,       ///< contrast enough, but the eyes do not see the same
  too_few_matches,     ///< too little of what was seen before is seen again
  no_agreement,        ///< what is seen again does not agree on a motion
  motion_too_large,    ///< they agree on a motion that no camera makes between two images
  too_uncertain,       ///< what is seen does not fix the motion
};
/// In words, for a person.
[[nodiscard]] const char* text_of(NoEstimate reason);
/// As one word, for programs: "too_few_matches".
[[nodiscard]] const char* word_of(NoEstimate reason);

}  // namespace striate::perception
