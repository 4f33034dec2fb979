#include <fmt/format.h>

#include <cstdint>

#include "striate/platform/datasets/trajectories/trajectory.hpp"

namespace striate::datasets {

std::string tum_text(const std::vector<TimedPose>& poses) {
  std::string text = "# timestamp tx ty tz qx qy qz qw\n";
  for (const TimedPose& pose : poses) {
    const cv::Vec4d q = quaternion_of(pose.rotation);
    const bool before = pose.stamp_ns < 0;
    const std::uint64_t ns = before ? 0 - static_cast<std::uint64_t>(pose.stamp_ns)
                                    : static_cast<std::uint64_t>(pose.stamp_ns);
    text +=
        fmt::format("{}{}.{:09} {:.9f} {:.9f} {:.9f} {:.9f} {:.9f} {:.9f} {:.9f}\n",
                    before ? "-" : "", ns / 1'000'000'000, ns % 1'000'000'000, pose.position_m[0],
                    pose.position_m[1], pose.position_m[2], q[0], q[1], q[2], q[3]);
  }
  return text;
}

}  // namespace striate::datasets
