#pragma once

#include <array>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "striate/memory/short_term/familiar_landmarks.hpp"
#include "striate/perception/recognition/recogniser.hpp"

namespace striate::agent {

/// A landmark that a picture shows. Places are in pixels of the picture as it was given.
struct KnownThing {
  std::string name;
  int view = 0;             ///< which of its views agrees best, from 0
  int inliers = 0;          ///< keypoints that agree on one pose
  double score = 0.0;       ///< 0..1, as of perception::Recognition
  double matched = 0.0;     ///< 0..1 of the view's keypoints
  double scale = 0.0;       ///< pixels of the picture a pixel of the view as it is stored
  double turned_rad = 0.0;  ///< from +u towards +v
  std::array<cv::Point2d, 4>
      quad;  ///< corners of the view: left upper, right upper, right lower, left lower
};

/// Looks for the landmarks of a long-term memory in single pictures, without a robot: in the whole
/// picture, turned any way.
class KnownThings {
 public:
  /// @param only names that are looked for; empty: all
  /// @throws UserError where a name is none of the memory's
  KnownThings(const memory::LandmarkKnowledge& knowledge,
              const perception::RecognitionSettings& settings,
              const std::vector<std::string>& only = {});

  [[nodiscard]] std::size_t views() const { return views_.size(); }
  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }

  /// What is there, most inliers first; each landmark once, by its best view.
  [[nodiscard]] std::vector<KnownThing> find(const cv::Mat3b& picture);

 private:
  struct View {
    int landmark = 0;
    int number = 0;
    perception::LandmarkView view;
  };
  perception::RecognitionSettings settings_;
  perception::Recogniser recogniser_;
  std::vector<View> views_;
  std::vector<std::string> names_;
};

}  // namespace striate::agent
