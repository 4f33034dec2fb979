#pragma once

#include <cstdint>
#include <optional>

#include "striate/config/settings.hpp"
#include "striate/perception/corridor/corridor_view.hpp"
#include "striate/perception/hanging_edges/hanging_edge_settings.hpp"
#include "striate/perception/keypoints/keypoints.hpp"
#include "striate/perception/low_things/low_things.hpp"
#include "striate/perception/motion/motion.hpp"
#include "striate/perception/obstacles/obstacles.hpp"
#include "striate/perception/percept.hpp"
#include "striate/perception/recognition/landmark_finder.hpp"
#include "striate/perception/saliency/saliency.hpp"
#include "striate/perception/stage_runner.hpp"
#include "striate/perception/stereo/disparity_source.hpp"
#include "striate/perception/stereo/stereo_matcher.hpp"
#include "striate/platform/interface/robot.hpp"

namespace striate::perception {

struct PerceptionSettings {
  /// Its `setting` also chooses how obstacles are found; its `width` is the working size of
  /// everything but keypoints.
  StereoSettings stereo;
  ObstacleSettings obstacles;
  LowThingSettings low_things;
  HangingEdgeSettings hanging_edges;
  MotionSettings motion;
  CorridorSettings corridor;
  /// The paper's in the cycle: a third of the robust one's time, and nothing drives by it.
  SaliencySettings saliency{.mode = SaliencyMode::paper};
  KeypointSettings keypoints;
  LandmarkFinderSettings recognition;
  /// Images; in between the percept has no keypoints; 0: never. Nothing in the cycle reads them:
  /// recognition finds its own, with Striate's descriptor.
  int keypoints_every = 0;
  int saliency_every = 1;  ///< images; in between the percept has no saliency
};

template <class V>
void visit(V& v, PerceptionSettings& s) {
  v.section("stereo", s.stereo);
  v.section("obstacles", s.obstacles);
  v.section("low_things", s.low_things);
  v.section("hanging_edges", s.hanging_edges);
  v.section("motion", s.motion);
  v.section("corridor", s.corridor);
  v.section("saliency", s.saliency);
  v.section("keypoints", s.keypoints);
  v.section("recognition", s.recognition);
  v.integer("saliency_every", s.saliency_every, {1, 100}, "saliency in every n-th image");
  v.integer("keypoints_every", s.keypoints_every, {0, 100},
            "keypoints in every n-th image; 0: never");
}

/// What perception may be built with beside its settings; all of it may be left out.
struct PerceptionExtras {
  /// What landmarks look like, from whoever remembers them.
  std::vector<KnownView> views;
  /// What the setting `recognition.most_time` is measured with; without it there is no limit of
  /// time. Must outlive the perception, as must the next.
  const Clock* clock = nullptr;
  /// A baseline's disparities instead of Striate's own stereo.
  DisparitySource* disparities = nullptr;
  /// The stages of plugins, which run after our own.
  const StageRegistry* stages = nullptr;
};

/// All of seeing: one image pair in, one percept out. Holds no memory of earlier images but
/// their count (and copies of the last ones where `saliency.motion_weight` is not zero or `motion`
/// is on), so the same images in the same order always give the same percepts.
class Perception {
 public:
  /// Throws UserError for settings out of range, std::invalid_argument for a view that is unsound
  /// (Recogniser::add).
  Perception(const PerceptionSettings& settings, const RobotDescription& robot,
             const PerceptionExtras& extras = {});

  /// No image: a percept that is not valid. One eye (`right` empty): what one image can give,
  /// the corridor's heading, saliency and keypoints. Unknown camera (`focal_px` <= 0):
  /// no obstacles and no corridor. Throws std::invalid_argument where left and right differ in
  /// size.
  /// @param base where the axle was when the image was taken, by odometry; without it nothing is
  /// found to move.
  /// @param expected which landmarks are looked for, and where first; without it none are.
  [[nodiscard]] Percept see(const StereoFrame& frame, const std::optional<Pose2>& base = {},
                            const LandmarkExpectations& expected = {});

 private:
  /// The left image in grey, as it came and at the working size.
  struct Greys {
    const cv::Mat1b& whole;
    const cv::Mat1b& small;
  };
  void match(const StereoFrame& frame, const Greys& greys, DisparityMap& disparity);
  void see_what_is_hard_to_see(const StereoFrame& frame, const Greys& greys,
                               const DisparityMap& disparity, ObstacleView& view);
  void measure_depth(const StereoFrame& frame, const Greys& greys, Percept& percept);

  PerceptionSettings settings_;
  RobotDescription robot_;
  StereoMatcher matcher_;
  LowThingFinder low_things_;
  KeypointFinder keypoint_finder_;
  SaliencyFinder saliency_finder_;
  MotionFinder motion_finder_;
  DisparitySource* other_disparities_;  ///< nullptr: Striate's own
  LandmarkFinder landmark_finder_;
  StageRunner stages_;
  std::int64_t pictures_ = 0;
};

}  // namespace striate::perception
