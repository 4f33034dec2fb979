#include "striate/perception/visual_odometry/no_estimate.hpp"

namespace striate::perception {

const char* text_of(NoEstimate reason) {
  switch (reason) {
    case NoEstimate::none:
      return "estimated";
    case NoEstimate::beginning:
      return "the beginning";
    case NoEstimate::too_little_texture:
      return "too little texture";
    case NoEstimate::eyes_disagree:
      return "the eyes do not see the same";
    case NoEstimate::too_few_matches:
      return "too little is seen again";
    case NoEstimate::no_agreement:
      return "what is seen again agrees on no motion";
    case NoEstimate::motion_too_large:
      return "the motion is too large";
    case NoEstimate::too_uncertain:
      return "what is seen does not fix the motion";
  }
  return "";
}

const char* word_of(NoEstimate reason) {
  switch (reason) {
    case NoEstimate::none:
      return "estimated";
    case NoEstimate::beginning:
      return "beginning";
    case NoEstimate::too_little_texture:
      return "too_little_texture";
    case NoEstimate::eyes_disagree:
      return "eyes_disagree";
    case NoEstimate::too_few_matches:
      return "too_few_matches";
    case NoEstimate::no_agreement:
      return "no_agreement";
    case NoEstimate::motion_too_large:
      return "motion_too_large";
    case NoEstimate::too_uncertain:
      return "too_uncertain";
  }
  return "";
}

}  // namespace striate::perception
