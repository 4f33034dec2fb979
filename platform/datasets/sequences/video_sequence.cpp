#include <fmt/format.h>

#include <cmath>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>

#include "striate/base/user_error.hpp"
#include "striate/platform/datasets/sequences/asked_moments.hpp"
#include "striate/platform/datasets/sequences/opened_sequences.hpp"

namespace striate::datasets {
namespace {

namespace fs = std::filesystem;

constexpr double kVideoNs_per_s = 1e9;

class VideoSequence final : public Sequence {
 public:
  VideoSequence(const std::vector<fs::path>& files, FoundCalibration found,
                const SequenceOptions& options)
      : asked_(options), both_(options.side_by_side) {
    for (const fs::path& file : files) {
      cv::VideoCapture capture;
      if (!capture.open(file.string())) {
        throw UserError(file.string() +
                        ": is no video that OpenCV can open\n    hint: give a folder of its "
                        "pictures: ffmpeg -i VIDEO pictures/%06d.png");
      }
      captures_.push_back(std::move(capture));
    }
    kind_ = files.size() == 2 ? "two videos" : "video";
    const double count = captures_.front().get(cv::CAP_PROP_FRAME_COUNT);
    if (count > 0.0 && count < 1e9) size_ = static_cast<std::size_t>(count);
    rate_hz_ = captures_.front().get(cv::CAP_PROP_FPS);
    if (!(rate_hz_ > 0.0 && rate_hz_ < 1e5)) rate_hz_ = 0.0;
    if (rate_hz_ == 0.0) remarks_.emplace_back("the video tells no rate: its frames have no times");
    calibration_ = std::move(found.model);
    calibration_file_ = std::move(found.file);
    exchanged_ = options.exchanged != (calibration_ && calibration_->eyes_exchanged);
  }

  [[nodiscard]] bool next(SequenceLook& look) override {
    while (true) {
      const std::size_t number = number_++;
      std::optional<double> since_s;
      if (rate_hz_ > 0.0) since_s = static_cast<double>(number) / rate_hz_;
      if (asked_.is_behind(number, since_s)) return false;
      std::size_t grabbed = 0;
      for (cv::VideoCapture& capture : captures_) grabbed += capture.grab() ? 1 : 0;
      if (grabbed < captures_.size()) {
        tell_end(number, grabbed);
        return false;
      }
      if (!asked_.takes(number, since_s)) continue;
      if (!decode(look)) {
        leave_out(fmt::format("frame {} cannot be decoded", number));
        continue;
      }
      look.number = number;
      look.name = fmt::format("frame {}", number);
      look.stamp_ns.reset();
      if (since_s) look.stamp_ns = std::llround(kVideoNs_per_s * *since_s);
      return true;
    }
  }

 private:
  void tell_end(std::size_t number, std::size_t grabbed) {
    if (grabbed > 0) remarks_.emplace_back("one video is shorter than the other");
    if (size_ > number) {
      leave_out(fmt::format("the video ends after {} frames; its head promises {}", number, size_));
    }
  }
  bool decode(SequenceLook& look) {
    cv::Mat one;
    if (!captures_[0].retrieve(one) || one.empty()) return false;
    const cv::Mat3b left = colour(one);
    look.left = left;
    look.right = cv::Mat3b();
    if (captures_.size() == 2) {
      cv::Mat other;
      if (!captures_[1].retrieve(other) || other.size() != one.size()) return false;
      look.right = colour(other);
    } else if (both_ || holds_both(calibration_, left.size())) {
      const int half = left.cols / 2;
      look.left = left.colRange(0, half).clone();
      look.right = left.colRange(half, 2 * half).clone();
    }
    if (exchanged_ && !look.right.empty()) std::swap(look.left, look.right);
    return look.left.cols >= 16 && look.left.rows >= 16;  // px, as of pictures
  }
  static cv::Mat3b colour(const cv::Mat& frame) {
    cv::Mat3b result;
    if (frame.channels() == 1) {
      cv::cvtColor(frame, result, cv::COLOR_GRAY2BGR);
    } else {
      result = frame.clone();
    }
    return result;
  }

  std::vector<cv::VideoCapture> captures_;
  AskedMoments asked_;
  bool both_ = false;
  bool exchanged_ = false;
  double rate_hz_ = 0.0;
  std::size_t number_ = 0;
};

}  // namespace

std::unique_ptr<Sequence> open_videos(const std::vector<fs::path>& files, FoundCalibration found,
                                      const SequenceOptions& options) {
  return std::make_unique<VideoSequence>(files, std::move(found), options);
}

}  // namespace striate::datasets
