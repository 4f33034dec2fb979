#pragma once

#include <string>

#include "app/mission.hpp"

namespace striate {

/// The pictures of a run: an overview every n cycles (camera, disparity, saliency, map with the
/// trail), and in the end the plan with all that happened. Nothing is written without a folder.
class MissionPictures {
 public:
  /// @param folder "" for none; @param every 0 for the plan alone.
  MissionPictures(std::string folder, int every);

  /// Called each cycle. @throws std::runtime_error when a picture cannot be written.
  void take(const Mission& mission) const;
  void finish(const Mission& mission, const RunResult& result) const;

 private:
  std::string folder_;
  int every_;
};

}  // namespace striate
