#pragma once

#include <memory>
#include <vector>

#include "striate/perception/stage.hpp"

namespace striate::perception {

/// The stages that are not ours, awake, in the order in which they run.
class StageRunner {
 public:
  /// @param stages nullptr: none. Throws what the stages throw that do not come up.
  StageRunner(const StageRegistry* stages, const RobotDescription& robot);

  /// Runs them all and fills Percept::figures; without stages it does nothing.
  void see(const StereoFrame& frame, Percept& percept);

 private:
  struct Awake {
    std::unique_ptr<Stage> stage;
    std::size_t figures = 0;  ///< how many are its
  };
  std::vector<Awake> stages_;
  std::vector<Figure> unknown_;  ///< of all stages, as they begin each image
  std::vector<double> values_;
};

}  // namespace striate::perception
