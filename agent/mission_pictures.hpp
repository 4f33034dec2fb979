#pragma once

#include <string>

#include "striate/agent/mission.hpp"
#include "striate/agent/pictures/animated_png.hpp"

namespace striate::agent {

/// The pictures of a run: an overview every n cycles (camera, disparity, saliency, map with the
/// trajectory), and in the end these as one moving picture, film.png, and the plan with all that
/// happened. Nothing is written without a folder.
class MissionPictures {
 public:
  /// @param folder "" for none; @param every 0 for the plan alone.
  MissionPictures(std::string folder, int every);

  /// Called each cycle. @throws std::runtime_error when an image cannot be written.
  void take(const Mission& mission);
  void finish(const Mission& mission, const RunResult& result) const;

 private:
  std::string folder_;
  int every_;
  pictures::AnimatedPng film_;
};

}  // namespace striate::agent
