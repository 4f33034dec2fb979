#pragma once

#include <memory>
#include <string>
#include <vector>

#include "striate/evaluation/object_set.hpp"

namespace striate::evaluation {

/// What a method says about one object in one scene: the keypoints that agree on a pose (paper: the
/// share of the view's descriptors that have a match, in percent); 0: nothing at all.
using ObjectScores = std::vector<double>;  ///< one an object

/// A way to find taught objects in a scene.
class ObjectMethod {
 public:
  virtual ~ObjectMethod() = default;
  [[nodiscard]] virtual std::string name() const = 0;
  virtual void teach(const std::vector<TaughtObject>& objects) = 0;
  [[nodiscard]] virtual ObjectScores look(const cv::Mat1b& scene) = 0;
};

/// Striate in its robust and in the paper's setting, then ORB, BRISK and SIFT with the same choice
/// of pairs (nearest against second nearest of a view) and the same vote and verification.
[[nodiscard]] std::vector<std::unique_ptr<ObjectMethod>> object_methods();

}  // namespace striate::evaluation
