#include "striate/base/user_error.hpp"
#include "striate/platform/pioneer/camera/bumblebee_image.hpp"
#include "striate/platform/pioneer/camera/frame_source.hpp"

#ifdef STRIATE_HAS_DC1394
#include <dc1394/dc1394.h>

#include <chrono>
#include <cstdlib>
#include <stdexcept>
#include <thread>
#endif

namespace striate::pioneer {

#ifdef STRIATE_HAS_DC1394
namespace {

/// Ten images at 10 Hz: then the camera has stopped sending
constexpr auto kPatience = std::chrono::seconds(1);
/// Between looks for an image: what a stamp may be late by
constexpr auto kLookAgain = std::chrono::milliseconds(2);
/// Images in the ring: 0.2 s at 20 Hz, the camera's fastest at 1024 x 768
constexpr unsigned kBuffers = 4;
/// The only mode that sends both eyes, byte by byte (libdc1394, Bumblebee-2)
constexpr dc1394video_mode_t kMode = DC1394_VIDEO_MODE_FORMAT7_3;

void must(dc1394error_t error, const char* what) {
  if (error != DC1394_SUCCESS) {
    throw std::runtime_error(std::string("bumblebee: ") + what + ": " +
                             dc1394_error_get_string(error));
  }
}

class BumblebeeSource final : public FrameSource {
 public:
  explicit BumblebeeSource(std::uint64_t guid) : guid_(guid), library_(dc1394_new()) {}
  ~BumblebeeSource() override {
    close();
    if (library_ != nullptr) dc1394_free(library_);
  }
  BumblebeeSource(const BumblebeeSource&) = delete;
  BumblebeeSource& operator=(const BumblebeeSource&) = delete;

  void open() override {
    close();
    if (library_ == nullptr) throw std::runtime_error("bumblebee: no FireWire bus is to be had");
    camera_ = dc1394_camera_new(library_, guid_ != 0 ? guid_ : first_guid());
    if (camera_ == nullptr) throw std::runtime_error("bumblebee: the camera does not answer");
    try {
      set_up();
    } catch (...) {
      close();
      throw;
    }
  }
  void close() override {
    if (camera_ == nullptr) return;
    dc1394_video_set_transmission(camera_, DC1394_OFF);
    dc1394_capture_stop(camera_);
    dc1394_camera_free(camera_);
    camera_ = nullptr;
  }

  [[nodiscard]] bool grab(cv::Mat3b& left, cv::Mat3b& right) override {
    const auto end = std::chrono::steady_clock::now() + kPatience;
    dc1394video_frame_t* frame = nullptr;
    // Asked again and again: waiting inside the library would never end without an image.
    while (frame == nullptr) {
      must(dc1394_capture_dequeue(camera_, DC1394_CAPTURE_POLICY_POLL, &frame), "picture");
      if (frame != nullptr) break;
      if (std::chrono::steady_clock::now() > end) return false;
      std::this_thread::sleep_for(kLookAgain);
    }
    const cv::Size size(static_cast<int>(frame->size[0]), static_cast<int>(frame->size[1]));
    const std::span<const std::uint8_t> raw(frame->image, frame->image_bytes);
    const bool whole = dc1394_capture_is_frame_corrupt(camera_, frame) == DC1394_FALSE &&
                       split_bumblebee(raw, size, left, right);
    taken_at_ = std::chrono::microseconds(frame->timestamp);
    must(dc1394_capture_enqueue(camera_, frame), "picture");
    return whole;
  }
  [[nodiscard]] std::optional<Duration> taken_at() const override { return taken_at_; }

 private:
  std::uint64_t first_guid() {
    dc1394camera_list_t* list = nullptr;
    must(dc1394_camera_enumerate(library_, &list), "looking for cameras");
    const bool any = list->num > 0;
    const std::uint64_t guid = any ? list->ids[0].guid : 0;
    dc1394_camera_free_list(list);
    if (!any) throw std::runtime_error("bumblebee: no FireWire camera is found");
    return guid;
  }
  /// Format 7 mode 3 gives both eyes' raw bytes in 16-bit pixels.
  void set_up() {
    must(dc1394_video_set_iso_speed(camera_, DC1394_ISO_SPEED_400), "speed");
    must(dc1394_video_set_mode(camera_, kMode), "mode");
    unsigned width = 0;
    unsigned height = 0;
    must(dc1394_format7_get_max_image_size(camera_, kMode, &width, &height), "size");
    must(dc1394_format7_set_roi(camera_, kMode, DC1394_COLOR_CODING_RAW16, DC1394_USE_MAX_AVAIL, 0,
                                0, static_cast<int>(width), static_cast<int>(height)),
         "image format");
    must(dc1394_capture_setup(camera_, kBuffers, DC1394_CAPTURE_FLAGS_DEFAULT), "capture");
    must(dc1394_video_set_transmission(camera_, DC1394_ON), "start");
  }

  std::uint64_t guid_;
  dc1394_t* library_;
  dc1394camera_t* camera_ = nullptr;
  std::optional<Duration> taken_at_;
};

}  // namespace

bool knows_bumblebee() {
  return true;
}

std::unique_ptr<FrameSource> make_bumblebee_source(const std::string& guid) {
  char* end = nullptr;
  const std::uint64_t number = std::strtoull(guid.c_str(), &end, 16);
  if (*end != '\0') {
    throw UserError("'bumblebee:" + guid + "': the camera's GUID is a hexadecimal number");
  }
  return std::make_unique<BumblebeeSource>(number);
}

#else

bool knows_bumblebee() {
  return false;
}

std::unique_ptr<FrameSource> make_bumblebee_source(const std::string& /*guid*/) {
  throw UserError(
      "bumblebee: this program was built without libdc1394\n"
      "  hint: install libdc1394-dev, configure and build again");
}

#endif

}  // namespace striate::pioneer
