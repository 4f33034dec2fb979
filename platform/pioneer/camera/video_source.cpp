#include <chrono>
#include <filesystem>
#include <opencv2/videoio.hpp>
#include <stdexcept>
#include <thread>
#include <vector>

#include "striate/base/user_error.hpp"
#include "striate/platform/pioneer/camera/frame_source.hpp"

namespace striate::pioneer {
namespace {

using Steady = std::chrono::steady_clock;
constexpr double kUsualRate_hz = 10.0;  // for a file that does not say; the paper's cycle

class VideoSource final : public FrameSource {
 public:
  explicit VideoSource(std::vector<std::string> names) : names_(std::move(names)) {}

  void open() override {
    captures_.clear();
    for (const std::string& name : names_) {
      if (!std::filesystem::exists(name)) throw std::runtime_error(name + ": is not there");
      cv::VideoCapture capture;
      is_file_ = std::filesystem::is_regular_file(name);
      // A device is opened by its driver, not by whatever decodes files.
      const bool good = is_file_ ? capture.open(name) : capture.open(name, cv::CAP_V4L2);
      if (!good) throw std::runtime_error(name + ": OpenCV opens no video there");
      captures_.push_back(std::move(capture));
    }
    const double rate_hz = captures_.front().get(cv::CAP_PROP_FPS);
    period_ = std::chrono::duration_cast<Steady::duration>(
        std::chrono::duration<double>(1.0 / (rate_hz > 0.0 ? rate_hz : kUsualRate_hz)));
    due_ = Steady::now();
  }
  void close() override { captures_.clear(); }

  [[nodiscard]] bool grab(cv::Mat3b& left, cv::Mat3b& right) override {
    if (is_file_) {
      std::this_thread::sleep_until(due_);
      due_ += period_;
    }
    // Both shutters first, so that the two images are of nearly one moment.
    for (cv::VideoCapture& capture : captures_) {
      if (!capture.grab()) return false;
    }
    if (captures_.size() == 2) {
      return captures_[0].retrieve(left_) && captures_[1].retrieve(right_) &&
             hand_out(left_, right_, left, right);
    }
    if (!captures_.front().retrieve(left_) || left_.cols < 2) return false;
    const int half = left_.cols / 2;
    return hand_out(left_.colRange(0, half), left_.colRange(half, 2 * half), left, right);
  }

  /// A device's driver notes when a buffer was filled; a file has no clock.
  [[nodiscard]] std::optional<Duration> taken_at() const override {
    if (is_file_) return std::nullopt;
    const double taken_ms = captures_.front().get(cv::CAP_PROP_POS_MSEC);
    if (!(taken_ms > 0.0)) return std::nullopt;
    return std::chrono::duration_cast<Duration>(
        std::chrono::duration<double, std::milli>(taken_ms));
  }

 private:
  static bool hand_out(const cv::Mat& from_left, const cv::Mat& from_right, cv::Mat3b& left,
                       cv::Mat3b& right) {
    if (from_left.type() != CV_8UC3 || from_right.size() != from_left.size()) return false;
    from_left.copyTo(left);
    from_right.copyTo(right);
    return true;
  }

  std::vector<std::string> names_;
  std::vector<cv::VideoCapture> captures_;
  bool is_file_ = false;
  Steady::duration period_{};
  Steady::time_point due_;
  cv::Mat left_;
  cv::Mat right_;
};

}  // namespace

std::unique_ptr<FrameSource> make_video_source(const std::string& spec) {
  const std::size_t comma = spec.find(',');
  std::vector<std::string> names{spec.substr(0, comma)};
  if (comma != std::string::npos) names.push_back(spec.substr(comma + 1));
  for (const std::string& name : names) {
    if (name.empty()) {
      throw UserError("'video:" + spec +
                      "': a device or file is missing\n"
                      "  hint: video:/dev/video0, or video:/dev/video0,/dev/video2");
    }
  }
  return std::make_unique<VideoSource>(std::move(names));
}

}  // namespace striate::pioneer
