#include <algorithm>

#include "striate/behaviours/control/safety_limiter.hpp"
#include "striate/memory/short_term/short_term_memory.hpp"
#include "striate/perception/perception.hpp"
#include "striate/platform/pioneer/camera/network_camera.hpp"
#include "tests/fuzz/fuzz_target.hpp"
#include "tests/fuzz/odd_numbers.hpp"

using namespace striate;

namespace {

/// A textured wall, farther on the right, so that there is disparity of many kinds.
StereoFrame textured_pair(int width_px, int height_px) {
  StereoFrame frame;
  frame.left = cv::Mat3b(height_px, width_px);
  frame.right = cv::Mat3b(height_px, width_px);
  const auto grey = [](int u, int v) {
    std::uint32_t x = static_cast<std::uint32_t>(u / 3) * 2654435761U +
                      static_cast<std::uint32_t>(v / 3) * 40503U;
    x = (x ^ (x >> 15U)) * 0x2C1B3C6DU;
    return static_cast<std::uint8_t>(40 + (x >> 16U) % 180);
  };
  for (int v = 0; v < height_px; ++v) {
    for (int u = 0; u < width_px; ++u) {
      const int shift = 2 + 20 * u / width_px + 4 * v / height_px;
      frame.left(v, u) = cv::Vec3b::all(grey(u, v));
      frame.right(v, u) = cv::Vec3b::all(grey(u + shift, v));
    }
  }
  frame.focal_px = 1.27 * width_px;
  frame.centre_u_px = 0.5 * (width_px - 1);
  frame.centre_v_px = 0.5 * (height_px - 1);
  frame.baseline_m = 0.12;
  return frame;
}

const std::vector<StereoFrame>& pairs() {
  static const std::vector<StereoFrame> all = {textured_pair(160, 120), textured_pair(64, 48),
                                               textured_pair(128, 16), textured_pair(40, 160)};
  return all;
}

/// A robot whose camera's header says what the input wants.
struct OddRobot {
  pioneer::StereoCameraSettings camera;
  RobotDescription body;
  HeadPose head;
  Pose2 odometry;
  StereoFrame sent = pairs().front();

  [[nodiscard]] std::vector<double*> numbers() {
    // In the header first: they count most.
    return {&sent.focal_px,        &sent.centre_u_px,  &sent.centre_v_px, &sent.baseline_m,
            &camera.field_rad,     &camera.baseline_m, &head.pan_rad,     &head.tilt_rad,
            &body.camera_height_m, &odometry.x_m,      &odometry.y_m,     &odometry.heading_rad};
  }
  /// What settings and devices check themselves.
  void keep_settings_in_their_ranges() {
    const auto within = [](double& value, double least, double most) {
      value = std::isfinite(value) ? std::clamp(value, least, most) : least;
    };
    within(camera.field_rad, radians(10), radians(120));
    within(camera.baseline_m, 0.01, 1.0);
    within(head.pan_rad, -kPi, kPi);
    within(head.tilt_rad, -1.5, 1.5);
    within(body.camera_height_m, 0.1, 2.5);
    for (double* place : {&odometry.x_m, &odometry.y_m, &odometry.heading_rad}) {
      within(*place, -1e6, 1e6);
    }
  }
};

}  // namespace

/// The input changes numbers of a camera's header, and of the robot it sits on, from image to
/// image; what the camera's driver lets through goes through all of the vision, into memory and the
/// limiter.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  OddRobot robot;
  fuzz::OddNumbers odd(data, size);
  bool more = odd.next();
  const StereoFrame& pair = pairs()[odd.which(pairs().size())];
  robot.sent = pair;
  if (more && odd.raw() % 2 == 0) {  // a camera of another kind, which says so
    robot.camera.field_rad = odd.changed(robot.camera.field_rad);
    robot.keep_settings_in_their_ranges();
    robot.sent.focal_px = 0.5 * pair.left.cols / std::tan(0.5 * robot.camera.field_rad);
  }
  pioneer::StreamDevice line(robot.camera);
  line.line_up(TimePoint(std::chrono::milliseconds(100)));
  perception::Perception perception({}, robot.body);
  memory::ShortTermMemory memory({}, robot.body);
  behaviours::SafetyLimiter limiter({}, robot.body);
  Senses senses;
  for (std::uint32_t number = 1; number < 7; ++number, more = odd.next()) {
    if (more) {
      const std::vector<double*> numbers = robot.numbers();
      double& one = *numbers[odd.which(numbers.size())];
      one = odd.changed(one);
      robot.keep_settings_in_their_ranges();
    }
    senses.now = TimePoint(std::chrono::milliseconds(100 * number));
    StereoFrame frame = robot.sent;
    frame.stamp = senses.now;
    // As the wire can carry them; what is odd is for the receiving side.
    for (double* value : {&frame.focal_px, &frame.centre_u_px, &frame.centre_v_px}) {
      *value = std::isfinite(*value) ? std::clamp(*value, 0.0, 4.29e6) : 4.29e6;
    }
    frame.baseline_m =
        std::isfinite(frame.baseline_m) ? std::clamp(frame.baseline_m, 0.0, 4.29e3) : 0.0;
    line.receive(pioneer::image_stream::encode(frame, number), senses.now);
    senses.stereo = line.newest();
    senses.stereo.head = robot.head;
    senses.odometry = {senses.now, robot.odometry, 0.0, 0.0};
    senses.head = robot.head;
    const perception::Percept percept = perception.see(senses.stereo, robot.odometry);
    memory.update(senses, percept);
    behaviours::Wish wish;
    wish.forward_m_s = 0.5;
    wish.stamp = senses.now;
    const behaviours::Limited sent = limiter.limit(wish, senses, memory);
    if (!std::isfinite(sent.command.forward_m_s)) __builtin_trap();
  }
  return 0;
}

std::vector<std::string> striate::fuzz::seeds() {
  return fuzz::lists_of_changes();
}
