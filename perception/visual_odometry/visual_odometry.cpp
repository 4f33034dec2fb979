#include "striate/perception/visual_odometry/visual_odometry.hpp"

#include <algorithm>
#include <utility>

#include "striate/perception/visual_odometry/follow_points.hpp"
#include "striate/perception/visual_odometry/refined_keyframe.hpp"
#include "striate/perception/visual_odometry/stereo_points.hpp"
#include "striate/perception/visual_odometry/striate_features.hpp"

namespace striate::perception {
namespace {

/// Of the width: with less motion in the image no keyframe is made, whatever is lost from sight, so
/// that a camera that stands keeps the one that it has (by hand)
constexpr double kLeastFlow = 0.01;

}  // namespace

class VisualOdometry::Parts {
 public:
  Parts(const VisualOdometrySettings& settings, FeatureSource source)
      : settings_(settings), source_(std::move(source)), keyframe_(settings.keyframes) {}

  const VisualPose& see(const StereoView& given) {
    check_view(given);
    StereoLook look;
    look_with_both(narrowed(given, settings_.width_px), source_, settings_, look);
    pose_.points = static_cast<int>(look.points.size());
    pose_.matches = pose_.agreeing = 0;
    pose_.begun_anew = pose_.keyframe = false;
    pose_.noise_px = 0.0;
    const StereoLook& then = keyframe_.look();
    if (has_keyframe_ && (look.eyes != then.eyes || look.size != then.size)) {
      has_keyframe_ = false;
      way_lost_ = true;
    }
    if (pose_.points < settings_.least_points) {
      ++lost_;
      pose_.reason = why_so_few(look);
    } else if (!has_keyframe_) {
      begin(std::move(look), NoEstimate::beginning);
    } else {
      follow(std::move(look));
    }
    ++number_;
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
    pose_.begun_anew = way_lost_;
    way_lost_ = false;
    velocity_ = {};
    last_from_keyframe_ = {};
    last_is_other_ = false;
    lost_ = 0;
    for (StereoPoint& point : look.points) point.track = next_track_++;
    keyframe_.begin(std::move(look), pose_.world_from_camera, number_);
    has_keyframe_ = true;
    best_agreeing_ = 0;
    pose_.keyframe_number = number_;
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
    const double images = 1.0 + std::min(lost_, settings_.most_lost);
    const double depth_m = followed.median_depth_m;
    if (cv::norm(turn_of(now_from_last.rotation)) > settings_.most_turn_rad * images ||
        cv::norm(now_from_last.way_m) > settings_.most_way * depth_m * images) {
      followed.reason = NoEstimate::motion_too_large;
    } else if (spread_of(followed.motion.covariance, 0) > settings_.most_doubt * depth_m ||
               spread_of(followed.motion.covariance, 3) > settings_.most_doubt_rad) {
      followed.reason = NoEstimate::too_uncertain;
    }
  }

  void follow(StereoLook look) {
    Followed followed = follow_from(keyframe_.look(), last_from_keyframe_, look);
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
      way_lost_ = true;
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
    pose_.noise_px = noise_px_ = followed.motion.noise_px;
    pose_.camera_from_keyframe = now_from_keyframe;
    pose_.keyframe_number = keyframe_.number();
    pose_.covariance = followed.motion.covariance;
    pose_.world_from_camera =
        straightened(keyframe_.world_from_keyframe() * inverse(now_from_keyframe));
    for (StereoPoint& point : look.points) point.track = -1;
    for (const FollowedPoint& point : followed.points) {
      StereoPoint& now = look.points[point.now];
      const StereoPoint& then = keyframe_.look().points[point.then];
      now.track = then.track;
      now.sight = point.sight;
      now.level = then.level;
    }
    for (StereoPoint& point : look.points) {
      if (point.track < 0) point.track = next_track_++;
    }
    last_ = std::move(look);
    last_number_ = number_;
    last_is_other_ = true;
    best_agreeing_ = std::max(best_agreeing_, pose_.agreeing);
    if (pose_.agreeing < settings_.keep_share * best_agreeing_ &&
        followed.median_flow_px > kLeastFlow * last_.size.width) {
      take_last_as_keyframe();
      pose_.keyframe = true;
      pose_.world_from_camera = keyframe_.world_from_keyframe();
    }
  }

  void take_last_as_keyframe() {
    keyframe_.replace(std::move(last_), last_from_keyframe_, last_number_, noise_px_);
    last_from_keyframe_ = {};
    last_is_other_ = false;
    best_agreeing_ = 0;
  }

  VisualOdometrySettings settings_;
  FeatureSource source_;
  VisualPose pose_;
  std::size_t number_ = 0;  ///< of views that were seen
  RefinedKeyframe keyframe_;
  bool has_keyframe_ = false;
  bool way_lost_ = false;  ///< since the keyframe was given up; said where another begins
  StereoLook last_;        ///< the last view with an estimate, unless it has become the keyframe
  std::size_t last_number_ = 0;
  bool last_is_other_ = false;  ///< than the keyframe
  RigidMotion last_from_keyframe_;
  RigidMotion velocity_;   ///< of the last two views with an estimate: the later from the earlier
  double noise_px_ = 0.0;  ///< of the last view with an estimate
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
