#include "striate/agent/plausible_senses.hpp"

#include <stdexcept>

#include "striate/platform/interface/plausible.hpp"

namespace striate::agent {

std::string refuse_implausible(Senses& senses, const StereoFrame& before) {
  if (const std::string why = why_implausible(senses); !why.empty()) {
    throw std::runtime_error("the robot cannot feel this: " + why);
  }
  std::string why = why_implausible(senses.stereo);
  if (why.empty()) return why;
  senses.stereo = before;
  return "the image is refused: " + why;
}

}  // namespace striate::agent
