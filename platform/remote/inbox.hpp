#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>

#include "striate/platform/remote/camera_model.hpp"
#include "striate/platform/remote/remote_settings.hpp"
#include "striate/platform/remote/stamp_map.hpp"
#include "striate/platform/remote/stereo_pairing.hpp"

namespace striate::remote {

enum class Eye { left, right };

/// What messages say, as senses: the newest of each, stamped in body time. What cannot be is put
/// aside and changes nothing, and `trouble` says why. No thread, no clock: whatever carries the
/// messages fills it. `stamp_ns` is the sender's, 0 where it gave none.
class Inbox {
 public:
  explicit Inbox(const RemoteSettings& settings);

  void take_eye(Eye eye, EyeImage image, TimePoint arrived);
  void take_camera(Eye eye, const EyeInfo& info);
  /// `odometry.stamp` is set here; the first pose becomes the origin.
  void take_odometry(Odometry odometry, std::int64_t stamp_ns, TimePoint arrived);
  /// The stamps of scans are set here, too.
  void take_laser(RangeScan scan, std::int64_t stamp_ns, TimePoint arrived);
  void take_sonar(RangeScan scan, std::int64_t stamp_ns, TimePoint arrived);
  void take_head(HeadPose head, std::int64_t stamp_ns, TimePoint arrived);
  /// A pair of a camera that is no topic, stamped in body time. `head` is set here.
  void take_frame(StereoFrame frame, TimePoint arrived);
  /// A message that could not be read.
  void refuse(const std::string& why) { trouble_ = why; }
  /// Of a pixel: the most that either eye has used so far; see image_codec.hpp.
  [[nodiscard]] int& bits() { return bits_; }

  /// Everything but `now`.
  [[nodiscard]] const Senses& senses() const { return senses_; }
  /// When each came last; nothing: not yet.
  [[nodiscard]] std::optional<TimePoint> images_came() const { return images_came_; }
  [[nodiscard]] std::optional<TimePoint> odometry_came() const { return odometry_came_; }
  [[nodiscard]] std::optional<TimePoint> laser_came() const { return laser_came_; }
  [[nodiscard]] bool camera_known() const { return camera_.known(); }
  [[nodiscard]] bool camera_swapped() const { return camera_.swapped(); }
  /// Why the newest message that could not be used was refused; "" while all could.
  [[nodiscard]] const std::string& trouble() const { return trouble_; }
  /// The sender's clock at a moment of ours, ns, never ahead of it; nothing while it is not known.
  [[nodiscard]] std::optional<std::int64_t> sender_ns(TimePoint ours) const {
    return stamps_.to_sender(ours);
  }
  [[nodiscard]] const RemoteSettings& settings() const { return settings_; }

 private:
  struct HeadAt {
    TimePoint stamp;
    HeadPose head;
  };
  [[nodiscard]] std::string why_unfit(const ImagePair& pair) const;
  TimePoint body_time(Stream stream, std::int64_t stamp_ns, TimePoint arrived);
  [[nodiscard]] HeadPose head_at(TimePoint stamp) const;

  RemoteSettings settings_;
  StampMap stamps_;
  StereoPairing pairing_;
  CameraModel camera_;
  int bits_ = 8;
  Senses senses_;
  std::deque<HeadAt> heads_;
  std::optional<Pose2> first_pose_;
  std::optional<TimePoint> images_came_;
  std::optional<TimePoint> odometry_came_;
  std::optional<TimePoint> laser_came_;
  std::string trouble_;
};

}  // namespace striate::remote
