#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "striate/agent/cognitive_cycle.hpp"

/// What others are shown of a cycle: a copy, so that whoever looks at it holds up nothing.
namespace striate::viewer {

/// A thing with a place, or an event about it.
struct NamedPlace {
  std::string name;
  Point2 place;
  double sigma_m = 0.0;  ///< standard deviation, larger axis
  bool seen = false;     ///< in this run; else it is only remembered
};

/// The floor as a grid of percentages: 0 free, 100 occupied, -1 unknown; x runs fastest.
struct FloorGrid {
  double cell_m = 0.0;
  Point2 corner;  ///< with the least x and y
  int columns = 0;
  int rows = 0;
  std::vector<std::int8_t> percent;
};

/// Where the robot is on the map of its memory; only where that is known.
struct OnMap {
  Pose2 pose;
  memory::PoseCovariance covariance{};  ///< of x, y, heading
  Pose2 odometry_frame;                 ///< in the map's frame
};

/// What changes slowly: once a second of the mission's clock.
struct SlowFacts {
  FloorGrid local;  ///< odometry frame
  std::vector<Point2> trajectory;
  std::vector<NamedPlace> landmarks;              ///< odometry frame
  std::vector<std::pair<Point2, Point2>> routes;  ///< map frame, both ends
  nlohmann::ordered_json short_term;              ///< as agent::memory_state() gives it
  double light_level = 0.0;
  double noise_level = 0.0;
  double seen_share = 0.0;
};

/// A landmark where it was recognised; pixels of the image.
struct SeenLandmark {
  std::string name;
  perception::Recognition found;
};

/// What vision found in one image beside the maps.
struct SeenFacts {
  cv::Size working_px;  ///< of the image that columns and regions are in
  cv::Size image_px;    ///< of the image that keypoints and landmarks are in
  HeadPose head;        ///< at the moment of the image
  double focal_px = 0.0;
  double centre_u_px = 0.0;
  double centre_v_px = 0.0;
  std::vector<perception::Column> columns;
  std::vector<perception::Keypoint> keypoints;
  std::vector<SeenLandmark> landmarks;
};

/// All that a cycle felt, saw, wanted and did.
struct CycleFacts {
  std::uint64_t number = 0;
  bool new_image = false;  ///< the images below were not there in the cycle before
  bool new_percept = false;
  bool slow_is_new = false;
  bool new_global = false;
  Senses senses;        ///< its images only where `new_image`
  std::string refused;  ///< why the body's newest image was not taken; "": it was
  double image_age_s = 0.0;

  // Of the newest percept; only where `new_percept`.
  TimePoint percept_stamp;
  perception::DisparityMap disparity;  ///< without confidence
  cv::Mat1f salience;
  std::vector<perception::SalientRegion> regions;
  std::vector<perception::Obstacle> obstacles;
  std::vector<perception::MovingThing> moving;
  SeenFacts seen;

  behaviours::Wish wish;
  behaviours::MotorOwner driver = behaviours::MotorOwner::nobody;
  MotorCommand sent;
  behaviours::LimitReason limited_by = behaviours::LimitReason::none;

  std::string doing;  ///< the action that ran; "": none
  tasks::MissionState state = tasks::MissionState::running;
  std::string reason;  ///< why it ended
  /// A letter a node of the task's outline, each before its children (json_schemas.hpp).
  std::string nodes;
  std::string node_reason;  ///< of the newest failure

  std::vector<std::string> recognised;  ///< landmarks in the image of this cycle
  struct Lesson {
    std::string name;
    bool recognised = false;  ///< else it was expected and missed
  };
  std::vector<Lesson> lessons;

  std::optional<OnMap> on_map;
  FloorGrid global;  ///< map frame, round the robot; only where `new_global`
  SlowFacts slow;    ///< only where `slow_is_new`
};

}  // namespace striate::viewer
