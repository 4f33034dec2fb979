#include "striate/perception/visual_odometry/visual_odometry.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "striate/perception/visual_odometry/follow_points.hpp"
#include "striate/perception/visual_odometry/keyframe_window.hpp"
#include "striate/perception/visual_odometry/stereo_points.hpp"
#include "striate/perception/visual_odometry/striate_features.hpp"

namespace striate::perception {
namespace {

/// Of the width: with less motion in the image no keyframe is made, whatever is lost from sight, so
/// that a camera that stands keeps the one that it has (by hand)
constexpr double kLeastFlow = 0.01;
/// Disparities of many images are not so much better than one's as chance alone would have it,
/// since patches err alike (by hand)
constexpr double kLeastThenNoise = 0.5;

double doubt_of(const cv::Matx66d& covariance, int from) {
  return std::sqrt(covariance(from, from) + covariance(from + 1, from + 1) +
                   covariance(from + 2, from + 2));
}

}  // namespace

class VisualOdometry::Parts {
 public:
  Parts(const VisualOdometrySettings& settings, FeatureSource source)
      : settings_(settings), source_(std::move(source)), window_(settings.keyframes) {}

  const VisualPose& see(const StereoView& given) {
    check_view(given);
    StereoLook look;
    look_with_both(narrowed(given, settings_.width_px), source_, settings_, look);
    pose_.features = static_cast<int>(look.left.size());
    pose_.points = static_cast<int>(look.points.size());
    pose_.matches = pose_.agreeing = 0;
    pose_.begun_anew = pose_.keyframe = false;
    pose_.noise_px = 0.0;
    if (has_keyframe_ && (look.eyes != keyframe_.eyes || look.size != keyframe_.size)) {
      has_keyframe_ = false;
      pose_.begun_anew = true;
    }
    if (pose_.points < settings_.least_points) {
      ++lost_;
      pose_.reason = why_so_few(look);
    } else if (!has_keyframe_) {
      begin(std::move(look), NoEstimate::beginning);
    } else {
      follow(std::move(look));
    }
    return pose_;
  }

 private:
  [[nodiscard]] NoEstimate why_so_few(const StereoLook& look) const {
    // Where few of many places are seen by both eyes they look at different things.
    constexpr int kManyMore = 3;  // times the points that are needed (by hand)
    return count_with_contrast(look) < kManyMore * settings_.least_points
               ? NoEstimate::too_little_texture
               : NoEstimate::eyes_disagree;
  }

  void begin(StereoLook look, NoEstimate reason) {
    pose_.reason = reason;
    pose_.keyframe = true;
    pose_.camera_from_keyframe = {};
    pose_.covariance = cv::Matx66d::zeros();
    velocity_ = {};
    last_from_keyframe_ = {};
    lost_ = 0;
    window_.clear();
    for (StereoPoint& point : look.points) point.track = next_track_++;
    keyframe_ = std::move(look);
    last_ = keyframe_;
    has_keyframe_ = true;
    world_from_keyframe_ = pose_.world_from_camera;
    best_agreeing_ = 0;
    add_to_window();
  }

  /// As it went on, and as it was: what does not move fast is found by either.
  [[nodiscard]] Followed follow_from(const StereoLook& then, const RigidMotion& last_from_then,
                                     const StereoLook& now) const {
    RigidMotion on = last_from_then;
    for (int k = 0; k <= std::min(lost_, 3); ++k) on = velocity_ * on;
    const RigidMotion expected[] = {on, last_from_then};
    Followed followed = follow_points(then, now, expected, settings_);
    if (followed.good()) judge(last_from_then, followed);
    return followed;
  }

  /// Is it a motion that can be, and that is known?
  void judge(const RigidMotion& last_from_then, Followed& followed) const {
    const RigidMotion now_from_last = followed.motion.now_from_then * inverse(last_from_then);
    const double images = 1.0 + lost_;
    const double depth_m = followed.median_depth_m;
    if (cv::norm(turn_of(now_from_last.rotation)) > settings_.most_turn_rad * images ||
        cv::norm(now_from_last.way_m) > settings_.most_way * depth_m * images) {
      followed.reason = NoEstimate::motion_too_large;
    } else if (doubt_of(followed.motion.covariance, 0) > settings_.most_doubt * depth_m ||
               doubt_of(followed.motion.covariance, 3) > settings_.most_doubt_rad) {
      followed.reason = NoEstimate::too_uncertain;
    }
  }

  void follow(StereoLook look) {
    Followed followed = follow_from(keyframe_, last_from_keyframe_, look);
    if (!followed.good() && last_is_other_) {
      Followed nearer = follow_from(last_, {}, look);
      if (nearer.good()) {
        take_last_as_keyframe();
        followed = std::move(nearer);
      }
    }
    pose_.matches = followed.matches;
    pose_.agreeing = static_cast<int>(followed.points.size());
    pose_.reason = followed.reason;
    if (!followed.good()) {
      if (++lost_ <= settings_.most_lost) return;
      pose_.begun_anew = true;
      begin(std::move(look), followed.reason);
      return;
    }
    take(std::move(look), followed);
  }

  void take(StereoLook look, const Followed& followed) {
    const RigidMotion& now_from_keyframe = followed.motion.now_from_then;
    const RigidMotion now_from_last = now_from_keyframe * inverse(last_from_keyframe_);
    // After images without an estimate it went so far in several steps.
    velocity_ = lost_ == 0 ? now_from_last : RigidMotion{};
    lost_ = 0;
    last_from_keyframe_ = now_from_keyframe;
    pose_.noise_px = followed.motion.noise_px;
    pose_.camera_from_keyframe = now_from_keyframe;
    pose_.covariance = followed.motion.covariance;
    pose_.world_from_camera = straightened(world_from_keyframe_ * inverse(now_from_keyframe));
    for (StereoPoint& point : look.points) point.track = -1;
    for (const FollowedPoint& point : followed.points) {
      StereoPoint& now = look.points[point.now];
      now.track = keyframe_.points[point.then].track;
      now.sight = point.sight;
      now.level = keyframe_.points[point.then].level;
    }
    for (StereoPoint& point : look.points) {
      if (point.track < 0) point.track = next_track_++;
    }
    last_ = std::move(look);
    last_is_other_ = true;
    best_agreeing_ = std::max(best_agreeing_, pose_.agreeing);
    if (pose_.agreeing < settings_.keep_share * best_agreeing_ &&
        followed.median_flow_px > kLeastFlow * last_.size.width) {
      take_last_as_keyframe();
      pose_.keyframe = true;
      pose_.world_from_camera = world_from_keyframe_;
    }
  }

  void take_last_as_keyframe() {
    world_from_keyframe_ = straightened(world_from_keyframe_ * inverse(last_from_keyframe_));
    keyframe_ = last_;
    last_from_keyframe_ = {};
    last_is_other_ = false;
    best_agreeing_ = 0;
    add_to_window();
    if (settings_.keyframes < 2 || !(pose_.noise_px > 0.0)) return;
    window_.refine(keyframe_.eyes, pose_.noise_px);
    world_from_keyframe_ = inverse(window_.newest().camera_from_world);
    take_refined_depths();
  }

  void add_to_window() {
    WindowKeyframe frame{inverse(world_from_keyframe_), {}};
    for (const StereoPoint& point : keyframe_.points) {
      frame.sights.push_back({point.track, point.sight, std::ldexp(1.0, point.level)});
    }
    std::ranges::sort(frame.sights, {}, &TrackSight::track);
    window_.add(std::move(frame));
  }

  /// A point that many images have seen is known better than by this one alone.
  void take_refined_depths() {
    constexpr double kFits = 3.0;  // of the noise; farther off the track is of two things
    for (StereoPoint& point : keyframe_.points) {
      const auto place = window_.places().find(point.track);
      if (place == window_.places().end()) continue;
      const cv::Vec3d p = window_.newest().camera_from_world * place->second.point_m;
      if (!(p[2] > 0.0)) continue;
      const double disparity_px = sight_of(keyframe_.eyes, p)[2];
      const double noise_px = std::ldexp(pose_.noise_px, point.level);
      if (std::abs(disparity_px - point.sight[2]) > kFits * noise_px) continue;
      point.sight[2] = disparity_px;
      point.then_noise = std::max(kLeastThenNoise, 1.0 / std::sqrt(place->second.sights));
    }
  }

  VisualOdometrySettings settings_;
  FeatureSource source_;
  KeyframeWindow window_;
  VisualPose pose_;
  bool has_keyframe_ = false;
  StereoLook keyframe_;
  RigidMotion world_from_keyframe_;
  StereoLook last_;             ///< the last view with an estimate
  bool last_is_other_ = false;  ///< than the keyframe
  RigidMotion last_from_keyframe_;
  RigidMotion velocity_;   ///< of the last two views with an estimate: the later from the earlier
  int lost_ = 0;           ///< views without an estimate since
  int best_agreeing_ = 0;  ///< points of this keyframe that were followed into one view
  std::int64_t next_track_ = 0;
};

VisualOdometry::VisualOdometry(const VisualOdometrySettings& settings)
    : VisualOdometry(settings, striate_features()) {}
VisualOdometry::VisualOdometry(const VisualOdometrySettings& settings, FeatureSource source)
    : parts_(std::make_unique<Parts>(settings, std::move(source))) {}
VisualOdometry::~VisualOdometry() = default;
VisualOdometry::VisualOdometry(VisualOdometry&&) noexcept = default;
VisualOdometry& VisualOdometry::operator=(VisualOdometry&&) noexcept = default;

const VisualPose& VisualOdometry::see(const StereoView& view) {
  return parts_->see(view);
}

}  // namespace striate::perception
