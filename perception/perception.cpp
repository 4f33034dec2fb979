#include "striate/perception/perception.hpp"

#include <opencv2/imgproc.hpp>
#include <stdexcept>
#include <utility>

#include "striate/perception/hanging_edges/hanging_edges.hpp"
#include "striate/perception/noise_estimate.hpp"
#include "striate/perception/obstacles/wall_completion.hpp"
#include "striate/perception/stereo/shrink_by_four.hpp"

namespace striate::perception {
namespace {

cv::Mat1b grey_picture(const cv::Mat3b& image) {
  cv::Mat1b grey;
  cv::cvtColor(image, grey, cv::COLOR_BGR2GRAY);
  return grey;
}

cv::Mat3b colour_at(const cv::Mat3b& image, const cv::Size& size) {
  if (is_four_times(image, size.width)) return means_of_fours(image);
  cv::Mat3b colour;
  cv::resize(image, colour, size, 0, 0, cv::INTER_AREA);
  return colour;
}

/// The camera of `frame` at the working size; pixel centres are at integers.
void describe_camera(const StereoFrame& frame, int width, DisparityMap& map) {
  const double scale = static_cast<double>(width) / frame.left.cols;
  map.focal_px = frame.focal_px * scale;
  map.centre_u_px = (frame.centre_u_px + 0.5) * scale - 0.5;
  map.centre_v_px = (frame.centre_v_px + 0.5) * scale - 0.5;
  map.baseline_m = frame.right.empty() ? 0.0 : frame.baseline_m;
}

/// Low things show by the second power of how near they are: only where the view reaches nearer
/// than this is twice the working size worth its time, 10 ms. The resting view begins at 2.1 m, a
/// glance down at 1.4 m.
constexpr double kWorthLookingFrom_m = 1.8;

bool shows_near_floor(const DisparityMap& map, const HeadPose& head,
                      const RobotDescription& robot) {
  const double fall = ViewGeometry(map, head, robot).fall_of_row(map.disparity_px.rows - 1);
  return fall * kWorthLookingFrom_m > robot.camera_height_m;
}

}  // namespace

Perception::Perception(const PerceptionSettings& settings, const RobotDescription& robot,
                       const PerceptionExtras& extras)
    : settings_(settings),
      robot_(robot),
      matcher_(settings.stereo),
      low_things_(settings.low_things, settings.stereo, robot),
      keypoint_finder_(settings.keypoints),
      saliency_finder_(settings.saliency),
      motion_finder_(settings.motion, robot),
      other_disparities_(extras.disparities),
      landmark_finder_(settings.recognition, extras.views, extras.clock),
      stages_(extras.stages, robot) {}

void Perception::match(const StereoFrame& frame, const Greys& greys, DisparityMap& disparity) {
  const int width = settings_.stereo.width;
  if (other_disparities_ != nullptr) {
    other_disparities_->measure(frame, disparity);
  } else if (settings_.stereo.wants_fine_greys()) {
    matcher_.match(to_fine_working_size(greys.whole, width),
                   to_fine_working_size(frame.right, width), disparity);
  } else {
    matcher_.match(greys.small, to_working_size(frame.right, width), disparity);
  }
}

void Perception::measure_depth(const StereoFrame& frame, const Greys& greys, Percept& percept) {
  if (frame.right.empty()) return;
  if (frame.right.size() != frame.left.size()) {
    throw std::invalid_argument("left and right image differ in size");
  }
  match(frame, greys, percept.disparity);
  if (frame.focal_px <= 0.0 || frame.baseline_m <= 0.0) return;
  const auto find =
      settings_.stereo.mode == StereoMode::paper ? find_obstacles_as_in_paper : find_obstacles;
  ObstacleView view = find(percept.disparity, frame.head, robot_, settings_.obstacles);
  if (settings_.stereo.mode == StereoMode::robust && other_disparities_ == nullptr) {
    see_what_is_hard_to_see(frame, greys, percept.disparity, view);
  }
  percept.columns = std::move(view.columns);
  percept.obstacles = std::move(view.obstacles);
}

/// Low things, and level edges that hang over the floor, at twice the working size.
void Perception::see_what_is_hard_to_see(const StereoFrame& frame, const Greys& greys,
                                         const DisparityMap& disparity, ObstacleView& view) {
  if (shows_near_floor(disparity, frame.head, robot_)) {
    const DisparityMap fine = low_things_.measure(frame, greys.whole, disparity);
    if (!fine.disparity_px.empty()) add_low_things(low_things_.judge(fine, frame.head), view);
  }
  const int width = kFinerSize * settings_.stereo.width;
  if (!settings_.hanging_edges.on || frame.left.cols < width) return;
  DisparityMap camera;
  describe_camera(frame, width, camera);
  const std::vector<HangingEdge> edges =
      find_hanging_edges(to_working_size(greys.whole, width), to_working_size(frame.right, width),
                         ViewGeometry(camera, frame.head, robot_), settings_.hanging_edges);
  add_hanging_edges(edges, disparity, ViewGeometry(disparity, frame.head, robot_), kFinerSize,
                    view);
}

Percept Perception::see(const StereoFrame& frame, const std::optional<Pose2>& base,
                        const LandmarkExpectations& expected) {
  Percept percept;
  percept.stamp = frame.stamp;
  if (frame.left.empty()) return percept;
  percept.valid = true;
  const cv::Mat1b grey = grey_picture(frame.left);
  const cv::Mat1b left = to_working_size(grey, settings_.stereo.width);
  percept.light_level = cv::mean(left)[0] / 255.0;
  percept.noise_level = estimate_noise(grey);

  describe_camera(frame, left.cols, percept.disparity);
  if (percept.disparity.focal_px > 0.0) {
    const ViewGeometry geometry(percept.disparity, frame.head, robot_);
    if (geometry.level_factor(0.0) > 0.0) percept.top_slope = -geometry.fall_of_row(0.0);
  }
  measure_depth(frame, {grey, left}, percept);
  percept.corridor = view_corridor(left, percept.disparity, frame.head, robot_, settings_.corridor);
  if (settings_.stereo.mode == StereoMode::robust) {
    complete_with_walls(percept.columns, percept.corridor, percept.disparity,
                        ViewGeometry(percept.disparity, frame.head, robot_));
  }
  if (settings_.motion.on && base && !percept.columns.empty()) {
    motion_finder_.find({frame.stamp, frame.head, *base, left, &percept.disparity}, percept.columns,
                        percept.moving);
  }
  if (pictures_ % settings_.saliency_every == 0) {
    const cv::Mat3b colour = colour_at(frame.left, left.size());
    percept.saliency = saliency_finder_.find(colour, percept.disparity,
                                             ViewGeometry(percept.disparity, frame.head, robot_));
  }
  if (settings_.keypoints_every > 0 && pictures_ % settings_.keypoints_every == 0) {
    percept.keypoints = keypoint_finder_.find(grey);
  }
  LandmarkLook look = landmark_finder_.find(
      grey, ViewGeometry(percept.disparity, frame.head, robot_), percept, expected);
  percept.recognitions = std::move(look.recognitions);
  percept.expected = std::move(look.expected);
  stages_.see(frame, percept);
  ++pictures_;
  return percept;
}

}  // namespace striate::perception
