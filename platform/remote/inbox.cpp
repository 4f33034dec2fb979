#include "striate/platform/remote/inbox.hpp"

#include <utility>

#include "striate/platform/interface/plausible.hpp"

namespace striate::remote {
namespace {

/// Poses of the head: 0.6 s at 100 Hz, longer than an image may be late (stale_s)
constexpr std::size_t kHeadsKept = 64;

}  // namespace

Inbox::Inbox(const RemoteSettings& settings)
    : settings_(settings),
      pairing_(from_seconds(settings.pairing_s)),
      camera_(settings.focal_px, settings.baseline_m) {
  senses_.head.tilt_rad = settings.fixed_tilt_rad;
}

TimePoint Inbox::body_time(Stream stream, std::int64_t stamp_ns, TimePoint arrived) {
  stamps_.learn(stream, stamp_ns, arrived);
  return stamps_.to_body(stamp_ns, arrived);
}

std::string Inbox::why_unfit(const ImagePair& pair) const {
  if (pair.left.image.size() != pair.right.image.size()) {
    return "left and right images have different sizes";
  }
  if (camera_.known()) return {};
  return camera_.swapped() ? "by CameraInfo the left and the right topics are swapped"
                           : "the camera's focal length and baseline are not known yet";
}

void Inbox::take_eye(Eye eye, EyeImage image, TimePoint arrived) {
  // Even an unpaired image tells how the clocks lie to each other.
  stamps_.learn(eye == Eye::left ? Stream::left : Stream::right, image.stamp_ns, arrived);
  const auto pair =
      eye == Eye::left ? pairing_.add_left(std::move(image)) : pairing_.add_right(std::move(image));
  if (!pair) return;
  if (const std::string why = why_unfit(*pair); !why.empty()) return refuse(why);
  // Once or twice in a session, while it is found out how many bits the camera has.
  if (pair->left.bits != pair->right.bits) return;
  StereoFrame frame;
  frame.stamp = stamps_.to_body(pair->left.stamp_ns, arrived);
  frame.left = pair->left.image;
  frame.right = pair->right.image;
  camera_.fill(frame);
  take_frame(std::move(frame), arrived);
}

void Inbox::take_frame(StereoFrame frame, TimePoint arrived) {
  frame.head = head_at(frame.stamp);
  if (const std::string why = why_implausible(frame); !why.empty()) return refuse(why);
  senses_.stereo = std::move(frame);
  images_came_ = arrived;
}

void Inbox::take_camera(Eye eye, const EyeInfo& info) {
  eye == Eye::left ? camera_.set_left(info) : camera_.set_right(info);
}

void Inbox::take_odometry(Odometry odometry, std::int64_t stamp_ns, TimePoint arrived) {
  Senses felt;
  felt.odometry = odometry;
  felt.odometry.stamp = {};
  if (const std::string why = why_implausible(felt); !why.empty()) return refuse(why);
  if (!first_pose_) first_pose_ = odometry.pose;
  odometry.pose = inverse_transform(*first_pose_, odometry.pose);
  odometry.stamp = body_time(Stream::odometry, stamp_ns, arrived);
  senses_.odometry = odometry;
  odometry_came_ = arrived;
}

void Inbox::take_laser(RangeScan scan, std::int64_t stamp_ns, TimePoint arrived) {
  Senses felt;
  felt.laser = std::move(scan);
  felt.laser.stamp = {};
  if (const std::string why = why_implausible(felt); !why.empty()) return refuse(why);
  senses_.laser = std::move(felt.laser);
  senses_.laser.stamp = body_time(Stream::laser, stamp_ns, arrived);
  laser_came_ = arrived;
}

void Inbox::take_sonar(RangeScan scan, std::int64_t stamp_ns, TimePoint arrived) {
  Senses felt;
  felt.sonar = std::move(scan);
  felt.sonar.stamp = {};
  if (const std::string why = why_implausible(felt); !why.empty()) return refuse(why);
  senses_.sonar = std::move(felt.sonar);
  senses_.sonar.stamp = body_time(Stream::sonar, stamp_ns, arrived);
}

void Inbox::take_head(HeadPose head, std::int64_t stamp_ns, TimePoint arrived) {
  senses_.head = head;
  // Wheels and head may be told by several publishers: this topic tells nothing of clocks.
  heads_.push_back({stamps_.to_body(stamp_ns, arrived), head});
  if (heads_.size() > kHeadsKept) heads_.pop_front();
}

HeadPose Inbox::head_at(TimePoint stamp) const {
  HeadPose head = senses_.head;
  Duration nearest = Duration::max();
  for (const HeadAt& one : heads_) {
    const Duration apart = one.stamp > stamp ? one.stamp - stamp : stamp - one.stamp;
    if (apart >= nearest) continue;
    nearest = apart;
    head = one.head;
  }
  return head;
}

}  // namespace striate::remote
