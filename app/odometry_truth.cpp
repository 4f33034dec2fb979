#include "striate/app/odometry_truth.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "striate/base/counted.hpp"
#include "striate/base/say.hpp"
#include "striate/platform/datasets/calibration/read_sensor_place.hpp"

namespace striate::app {
namespace {

/// The truth of a set of EuRoC's is of the body, and its own file says where the camera is on it.
std::string sensor_of(const std::filesystem::path& truth) {
  if (truth.parent_path().filename() != "state_groundtruth_estimate0") return {};
  const std::filesystem::path sensor = truth.parent_path().parent_path() / "cam0" / "sensor.yaml";
  std::error_code error;
  if (!std::filesystem::exists(sensor, error)) return {};
  say(stderr, fmt::format("  note: the truth is of the body; {} says where the camera is (an "
                          "estimate of the body: --sensor body)\n",
                          sensor.string()));
  return sensor.string();
}

}  // namespace

void tell_trajectory(const char* which, const std::string& file,
                     const datasets::Trajectory& trajectory) {
  say(stderr, fmt::format("{}: {}, {} of {}\n", which, file,
                          counted(trajectory.poses.size(), "pose"), trajectory.format));
  for (const std::string& remark : trajectory.remarks) say(stderr, "  note: " + remark + "\n");
}

OdometryTruth read_truth(const std::string& path, const std::string& sensor,
                         datasets::KittiTimes times) {
  OdometryTruth truth;
  truth.trajectory = datasets::find_ground_truth(path, times);
  const std::filesystem::path file = datasets::ground_truth_file(path);
  tell_trajectory("truth", file.string(), truth.trajectory);
  if (sensor == "body") return truth;
  const std::string place = sensor.empty() ? sensor_of(file) : sensor;
  if (!place.empty()) truth.body_from_sensor = datasets::read_sensor_place(place);
  return truth;
}

}  // namespace striate::app
