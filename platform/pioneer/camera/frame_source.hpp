#pragma once

#include <memory>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <string>

#include "striate/base/time.hpp"

namespace striate::pioneer {

/// Where raw pairs come from. One thread at a time.
class FrameSource {
 public:
  virtual ~FrameSource() = default;
  /// @throws std::runtime_error saying what is not to be had.
  virtual void open() = 0;
  virtual void close() = 0;
  /// Waits for the next pair, a second or two at most. False: none came, or they are over.
  [[nodiscard]] virtual bool grab(cv::Mat3b& left, cv::Mat3b& right) = 0;
  /// When the newest pair was taken, by the source's own clock; nothing: it does not say. Pairs
  /// wait in the source's buffers while nobody grabs them, and are older than they look.
  [[nodiscard]] virtual std::optional<Duration> taken_at() const { return std::nullopt; }
};

/// Any camera or file that OpenCV's VideoCapture opens: one that shows both eyes side by side, or
/// one for each eye with a comma between. A file is played once, at its own pace.
/// @param spec "/dev/video0", "/dev/video0,/dev/video2", "drive.avi"
[[nodiscard]] std::unique_ptr<FrameSource> make_video_source(const std::string& spec);

/// Whether this program was built with libdc1394.
[[nodiscard]] bool knows_bumblebee();
/// A Bumblebee-2 on FireWire.
/// @param guid in hexadecimal; empty: the first camera that is found.
/// @throws UserError where the program was built without libdc1394.
[[nodiscard]] std::unique_ptr<FrameSource> make_bumblebee_source(const std::string& guid);

}  // namespace striate::pioneer
