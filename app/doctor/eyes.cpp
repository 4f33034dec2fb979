#include "striate/app/doctor/eyes.hpp"

#include <chrono>
#include <exception>
#include <opencv2/imgproc.hpp>
#include <thread>

#include "striate/perception/stereo/pair_check.hpp"
#include "striate/platform/pioneer/camera/make_stereo_camera.hpp"
#include "striate/platform/pioneer/steady_clock.hpp"

namespace striate::app {
namespace {

/// A camera that sends at all has by then: the slowest starts within a second or two (by hand)
constexpr auto kFirstImagePatience = std::chrono::seconds(3);
constexpr auto kBetweenGlances = std::chrono::milliseconds(20);  // not felt by who waits

StereoFrame first_image_of(const pioneer::PioneerSettings& settings) {
  const pioneer::SteadyClock clock;
  const auto camera = pioneer::make_stereo_camera(settings.devices.camera, settings.camera, clock);
  const auto end = std::chrono::steady_clock::now() + kFirstImagePatience;
  StereoFrame frame = camera->newest();
  while (frame.left.empty() && std::chrono::steady_clock::now() < end) {
    std::this_thread::sleep_for(kBetweenGlances);
    frame = camera->newest();
  }
  return frame;
}

}  // namespace

Finding look_at_pair_of(const std::string& about, const cv::Mat3b& left, const cv::Mat3b& right) {
  cv::Mat1b grey_left;
  cv::Mat1b grey_right;
  cv::cvtColor(left, grey_left, cv::COLOR_BGR2GRAY);
  cv::cvtColor(right, grey_right, cv::COLOR_BGR2GRAY);
  const perception::PairCheck check = perception::check_pair(grey_left, grey_right);
  const perception::PairFault fault = perception::fault_of(check);
  if (fault == perception::PairFault::none) {
    return {Finding::Grade::good, about, "left is left, and the rows agree", {}};
  }
  if (fault == perception::PairFault::unknown) {
    return {Finding::Grade::note, about, "the images show too few corners to tell left from right",
            "let it look at something with structure, 1 to 3 m away"};
  }
  return {Finding::Grade::wrong, about, perception::fault_text(check, left.cols),
          perception::fault_hint(fault)};
}

Findings look_at_eyes(const pioneer::PioneerSettings& settings) {
  try {
    const StereoFrame frame = first_image_of(settings);
    if (frame.left.empty() || frame.right.size() != frame.left.size()) return {};
    return {look_at_pair_of("eyes of " + settings.devices.camera, frame.left, frame.right)};
  } catch (const std::exception&) {
    return {};  // the camera's own finding says why
  }
}

}  // namespace striate::app
