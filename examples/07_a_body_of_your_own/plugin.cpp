#include "striate/agent/plugins/plugin.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

using namespace striate;

/// A robot on rails before a spotted wall. It has two eyes and can drive forward and back; it is
/// simulated here, as fast as the machine. With real motors and cameras, `sense` waits for the next
/// images, `send` talks to the motors, and `clock` is the machine's.
class RailRobot final : public Robot, private Clock {
 public:
  /// Its section of the robot's YAML.
  struct Settings {
    double wall_m = 4.0;
  };

  RailRobot(const Settings& settings, const RobotDescription& described)
      : description_(described), left_to_wall_m_(settings.wall_m), spots_(1000, 1500) {
    cv::theRNG().state = 7;  // the same spots each time
    cv::randu(spots_, 0, 256);
    cv::blur(spots_, spots_, {2, 2});
  }

  [[nodiscard]] const RobotDescription& description() const override { return description_; }
  [[nodiscard]] const Clock& clock() const override { return *this; }

  /// One cycle: time goes on, the robot moves as it was told, and the eyes see the wall.
  bool sense(Senses& senses) override {
    const double cycle_s = to_seconds(description_.cycle);
    now_ += description_.cycle;
    driven_m_ += speed_m_s_ * cycle_s;
    left_to_wall_m_ -= speed_m_s_ * cycle_s;
    senses.now = now_;
    senses.odometry.stamp = now_;
    senses.odometry.pose = {driven_m_, 0.0, 0.0};
    senses.odometry.forward_m_s = speed_m_s_;
    StereoFrame& eyes = senses.stereo;
    eyes.stamp = now_;
    eyes.focal_px = kWidth_px / 2.0 / std::tan(description_.view_rad / 2.0);
    eyes.centre_u_px = (kWidth_px - 1) / 2.0;
    eyes.centre_v_px = (kHeight_px - 1) / 2.0;
    eyes.baseline_m = kBaseline_m;
    eyes.left = seen_from(kBaseline_m / 2.0, eyes);
    eyes.right = seen_from(-kBaseline_m / 2.0, eyes);
    return true;
  }

  /// What the safety limiter let through.
  void send(const MotorCommand& command) override {
    const double most_m_s = description_.max_acceleration_m_s2 * to_seconds(description_.cycle);
    speed_m_s_ += std::clamp(command.forward_m_s - speed_m_s_, -most_m_s, most_m_s);
  }
  void stop() noexcept override { speed_m_s_ = 0.0; }

 private:
  static constexpr int kWidth_px = 320;
  static constexpr int kHeight_px = 240;
  static constexpr double kBaseline_m = 0.12;
  static constexpr double kSpots_per_m = 150.0;  // texels of the wall

  [[nodiscard]] TimePoint now() const override { return now_; }

  /// The wall through a pinhole so far to the left of the middle: a scale and a shift.
  [[nodiscard]] cv::Mat3b seen_from(double left_m, const StereoFrame& eyes) const {
    const double depth_m = std::max(0.1, left_to_wall_m_ - description_.camera_forward_m);
    const double scale = depth_m / eyes.focal_px * kSpots_per_m;  // texels a pixel
    const cv::Matx23d wall_of_pixel(
        scale, 0.0, spots_.cols / 2.0 - left_m * kSpots_per_m - scale * eyes.centre_u_px,  //
        0.0, scale, spots_.rows / 2.0 - scale * eyes.centre_v_px);
    cv::Mat1b grey;
    cv::warpAffine(spots_, grey, wall_of_pixel, {kWidth_px, kHeight_px},
                   cv::INTER_LINEAR | cv::WARP_INVERSE_MAP, cv::BORDER_REFLECT);
    cv::Mat3b image;
    cv::cvtColor(grey, image, cv::COLOR_GRAY2BGR);
    return image;
  }

  RobotDescription description_;
  double left_to_wall_m_;
  double driven_m_ = 0.0;
  double speed_m_s_ = 0.0;
  TimePoint now_;
  cv::Mat1b spots_;
};

template <class V>
void visit(V& v, RailRobot::Settings& s) {
  v.number("wall", s.wall_m, config::Unit::length, {1.0, 8.0}, "from the axle to the wall");
}

void enroll(agent::PluginRegistrar& plugin) {
  plugin.add(agent::body_entry<RailRobot>("rail_robot", "two eyes on rails before a wall"));
}

STRIATE_PLUGIN("wall", enroll)
