#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <thread>

#include "striate/platform/pioneer/camera/frame_source.hpp"
#include "striate/platform/pioneer/camera/rectifier.hpp"
#include "striate/platform/pioneer/camera/stereo_camera.hpp"
#include "striate/platform/pioneer/camera/stereo_camera_settings.hpp"
#include "striate/platform/pioneer/line_clock.hpp"
#include "striate/platform/pioneer/mailbox.hpp"

namespace striate::pioneer {

/// A camera at this machine: grabs, swaps, rectifies, stamps. What breaks is opened anew.
class GrabbingCamera final : public StereoCamera {
 public:
  /// `clock` must outlive this. @throws UserError for a calibration that is none.
  GrabbingCamera(std::unique_ptr<FrameSource> source, const StereoCameraSettings& settings,
                 const Clock& clock);
  ~GrabbingCamera() override;
  GrabbingCamera(const GrabbingCamera&) = delete;
  GrabbingCamera& operator=(const GrabbingCamera&) = delete;

  [[nodiscard]] StereoFrame newest() const override { return newest_.newest(); }
  [[nodiscard]] std::string trouble() const override { return trouble_.newest(); }

 private:
  void run();
  void grab_on();
  void note_trouble(const char* why) noexcept;
  void hand_on(const cv::Mat3b& left, const cv::Mat3b& right);
  [[nodiscard]] TimePoint taken_at();
  [[nodiscard]] StereoFrame as_it_is(const cv::Mat3b& left, const cv::Mat3b& right) const;

  std::unique_ptr<FrameSource> source_;
  StereoCameraSettings settings_;
  const Clock& clock_;
  std::optional<Rectifier> rectifier_;
  LineClock source_clock_;
  Mailbox<StereoFrame> newest_;
  Mailbox<std::string> trouble_;
  std::atomic<bool> ends_{false};
  std::thread thread_;  // last: it uses all of the above
};

}  // namespace striate::pioneer
