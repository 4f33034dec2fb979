#include "striate/app/doctor/devices.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>

#include "striate/app/doctor/eyes.hpp"
#include "striate/app/doctor/look_at_line.hpp"
#include "striate/base/user_error.hpp"
#include "striate/platform/pioneer/camera/frame_source.hpp"
#include "striate/platform/pioneer/camera/rectifier.hpp"
#include "striate/platform/pioneer/transport.hpp"
#include "striate/platform/pioneer/who_answers.hpp"

namespace striate::app {
namespace {

namespace fs = std::filesystem;
using Grade = Finding::Grade;

std::vector<fs::path> named(const fs::path& folder, const std::vector<std::string>& beginnings) {
  std::vector<fs::path> found;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename();
    for (const std::string& beginning : beginnings) {
      if (name.rfind(beginning, 0) == 0) found.push_back(entry.path());
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

Finding look_at_video(const std::string& url) {
  const std::string about = "camera " + url;
  try {
    const bool bee = url.rfind("bumblebee:", 0) == 0;
    const std::string spec = url.substr(url.find(':') + 1);
    const auto source =
        bee ? pioneer::make_bumblebee_source(spec) : pioneer::make_video_source(spec);
    source->open();
    cv::Mat3b left;
    cv::Mat3b right;
    if (source->grab(left, right)) {
      return {
          Grade::good, about, fmt::format("gives pairs of {} x {} px", left.cols, left.rows), {}};
    }
    return {Grade::wrong, about, "gives no image", "look at the cable, or give another device"};
  } catch (const std::exception& error) {
    return {Grade::wrong, about, error.what(), "correct the place in the robot file"};
  }
}

Finding look_at_calibration(const pioneer::StereoCameraSettings& camera) {
  const char* anew = "make it anew: striate calibrate FOLDER names the pairs that are wrong";
  try {
    const auto calibration = pioneer::read_calibration(camera.calibration);
    const pioneer::Rectifier rectifier(calibration, camera.width_px);
    const std::string what = fmt::format(
        "errs by {:.2f} px (reprojection {:.2f}, rectification {:.2f})",
        pioneer::error_px(calibration), calibration.reprojection_px, calibration.epipolar_px);
    switch (pioneer::exactness_of(calibration)) {
      case pioneer::Exactness::good:
        break;
      case pioneer::Exactness::poor:
        return {Grade::note, camera.calibration, what + "; distances will be wrong", anew};
      case pioneer::Exactness::useless:
        return {Grade::wrong, camera.calibration, what + "; nothing is matched rightly with it",
                anew};
      case pioneer::Exactness::unknown:
        return {Grade::note, camera.calibration, "does not say how exact it is", anew};
    }
    return {Grade::good, camera.calibration, what, {}};
  } catch (const UserError& error) {
    return {Grade::wrong, camera.calibration, error.what(), "striate calibrate FOLDER"};
  }
}

}  // namespace

Findings look_at_devices(const DeviceFolders& folders) {
  Findings findings;
  const auto ports = named(folders.dev, {"ttyUSB", "ttyACM"});
  for (const fs::path& port : ports) {
    findings.push_back(permission(port, "serial port", "dialout"));
    look_at_latency(port, folders.sys, findings);
  }
  if (ports.empty()) {
    findings.push_back({Grade::note, "serial ports", "no USB serial port is there",
                        "only a robot on TCP can be driven; plug the adapter in"});
  }
  const auto cameras = named(folders.dev, {"video"});
  for (const fs::path& camera : cameras) {
    findings.push_back(permission(camera, "camera", "video"));
  }
  if (cameras.empty()) {
    findings.push_back({Grade::note, "cameras", "none is there",
                        "only images from the network or a file can be seen"});
  }
  for (const fs::path& bus : named(folders.dev, {"fw"})) {
    findings.push_back(permission(bus, "FireWire", "video"));
  }
  if (!pioneer::knows_bumblebee()) {
    findings.push_back({Grade::note, "Bumblebee-2", "this program was built without libdc1394",
                        "apt-get install libdc1394-dev, and build again"});
  }
  return findings;
}

Findings look_at_places(const pioneer::PioneerSettings& settings) {
  using pioneer::Answerer;
  const pioneer::DevicePlaces& places = settings.devices;
  Findings findings;
  if (places.base.empty()) {
    return {{Grade::note, "robot", "the robot file names no base: it is for the simulator", {}}};
  }
  findings.push_back(look_at_line("base", places.base, Answerer::base));
  if (!places.turret.empty()) {
    const pioneer::ServoIds servos{static_cast<std::uint8_t>(settings.turret.pan_id),
                                   static_cast<std::uint8_t>(settings.turret.tilt_id)};
    findings.push_back(look_at_line("turret", places.turret, Answerer::turret, servos));
  }
  if (!places.laser.empty()) {
    const bool sick = settings.laser.kind == pioneer::LaserKind::lms200;
    findings.push_back(
        look_at_line("laser", places.laser, sick ? Answerer::lms200 : Answerer::hokuyo));
  }
  const std::string& camera = places.camera;
  if (camera.rfind("video:", 0) == 0 || camera.rfind("bumblebee:", 0) == 0) {
    findings.push_back(look_at_video(camera));
  } else if (!camera.empty()) {
    findings.push_back(look_at_line("camera", camera, Answerer::camera));
  }
  const bool camera_good = !camera.empty() && findings.back().grade == Grade::good;
  if (camera_good) {
    for (Finding& finding : look_at_eyes(settings)) findings.push_back(std::move(finding));
  }
  if (!settings.camera.calibration.empty()) {
    findings.push_back(look_at_calibration(settings.camera));
  }
  return findings;
}

}  // namespace striate::app
