#include "striate/platform/pioneer/camera/grabbing_camera.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "striate/platform/interface/plausible.hpp"

namespace striate::pioneer {
namespace {

/// A camera that was unplugged is back as soon as a hand can do it
constexpr auto kOpenAgain = std::chrono::milliseconds(500);
constexpr auto kLook = std::chrono::milliseconds(20);  // so soon is the end of the program noticed

}  // namespace

GrabbingCamera::GrabbingCamera(std::unique_ptr<FrameSource> source,
                               const StereoCameraSettings& settings, const Clock& clock)
    : source_(std::move(source)), settings_(settings), clock_(clock) {
  if (!settings.calibration.empty()) {
    rectifier_.emplace(usable_calibration(settings.calibration), settings.width_px);
  }
  thread_ = std::thread([this] { run(); });
}

GrabbingCamera::~GrabbingCamera() {
  ends_ = true;
  thread_.join();
}

/// Images that were rectified elsewhere, made smaller.
StereoFrame GrabbingCamera::as_it_is(const cv::Mat3b& left, const cv::Mat3b& right) const {
  StereoFrame frame;
  const double by = static_cast<double>(settings_.width_px) / left.cols;
  const cv::Size size(settings_.width_px, static_cast<int>(std::lround(left.rows * by)));
  cv::resize(left, frame.left, size, 0.0, 0.0, cv::INTER_AREA);
  cv::resize(right, frame.right, size, 0.0, 0.0, cv::INTER_AREA);
  frame.focal_px = size.width / 2.0 / std::tan(settings_.field_rad / 2.0);
  frame.centre_u_px = (size.width - 1) / 2.0;
  frame.centre_v_px = (size.height - 1) / 2.0;
  frame.baseline_m = settings_.baseline_m;
  return frame;
}

/// By the source's own clock, where it has one: the pair that waited least tells how it lies to
/// ours.
TimePoint GrabbingCamera::taken_at() {
  const TimePoint now = clock_.now();
  const auto taken = source_->taken_at();
  if (!taken) return now;
  source_clock_.heard(*taken, now);
  return std::min(now, source_clock_.at(*taken));
}

void GrabbingCamera::hand_on(const cv::Mat3b& left, const cv::Mat3b& right) {
  StereoFrame frame;
  const TimePoint stamp = taken_at() - from_seconds(settings_.latency_s);
  const cv::Mat3b& seen_left = settings_.swap ? right : left;
  const cv::Mat3b& seen_right = settings_.swap ? left : right;
  if (rectifier_) {
    rectifier_->rectify(seen_left, seen_right, frame);
  } else {
    frame = as_it_is(seen_left, seen_right);
  }
  frame.stamp = stamp;
  if (const std::string why = why_implausible(frame); !why.empty()) throw std::runtime_error(why);
  newest_.put(std::move(frame));
}

void GrabbingCamera::grab_on() {
  cv::Mat3b left;
  cv::Mat3b right;
  source_->open();
  source_clock_.begin_anew();
  while (!ends_) {
    if (!source_->grab(left, right)) {
      trouble_.put("no more images come");
      break;
    }
    hand_on(left, right);
    trouble_.put({});
  }
}

/// The images get old, and the robot stands. Nothing may leave the thread, for that would end the
/// program.
void GrabbingCamera::note_trouble(const char* why) noexcept {
  try {
    trouble_.put(why);
  } catch (...) {  // no memory for the words, either
  }
}

void GrabbingCamera::run() {
  while (!ends_) {
    try {
      grab_on();
    } catch (const std::exception& error) {
      note_trouble(error.what());
    } catch (...) {
      note_trouble("an unknown error");
    }
    try {
      source_->close();
    } catch (...) {  // what is broken may not be closed, either; it is opened anew
    }
    const auto end = std::chrono::steady_clock::now() + kOpenAgain;
    while (!ends_ && std::chrono::steady_clock::now() < end) std::this_thread::sleep_for(kLook);
  }
}

}  // namespace striate::pioneer
