#include "striate/perception/visual_odometry/no_estimate.hpp"

#include <iterator>

namespace striate::perception {
namespace {

struct ReasonWords {
  NoEstimate reason;
  const char* word;
  const char* text;
};

/// In the order of the reasons.
constexpr ReasonWords kReasons[] = {
    {NoEstimate::none, "estimated", "estimated"},
    {NoEstimate::beginning, "beginning", "the beginning"},
    {NoEstimate::too_little_texture, "too_little_texture", "too little texture"},
    {NoEstimate::eyes_disagree, "eyes_disagree", "the eyes do not see the same"},
    {NoEstimate::too_few_matches, "too_few_matches", "too little is seen again"},
    {NoEstimate::no_agreement, "no_agreement", "what is seen again agrees on no motion"},
    {NoEstimate::motion_too_large, "motion_too_large", "the motion is too large"},
    {NoEstimate::too_uncertain, "too_uncertain", "what is seen does not fix the motion"},
};

constexpr bool each_at_its_number() {
  for (std::size_t k = 0; k < std::size(kReasons); ++k) {
    if (kReasons[k].reason != static_cast<NoEstimate>(k)) return false;
  }
  return kReasons[std::size(kReasons) - 1].reason == NoEstimate::too_uncertain;  // the last one
}
static_assert(each_at_its_number());

}  // namespace

const char* text_of(NoEstimate reason) {
  return kReasons[static_cast<std::size_t>(reason)].text;
}

const char* word_of(NoEstimate reason) {
  return kReasons[static_cast<std::size_t>(reason)].word;
}

}  // namespace striate::perception
