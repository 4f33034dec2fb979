#pragma once

#include <cstdint>
#include <filesystem>
#include <opencv2/core/matx.hpp>
#include <string>
#include <vector>

namespace striate::datasets {

/// Where something was at a time, in a world of its own.
struct TimedPose {
  std::int64_t stamp_ns = 0;
  cv::Matx33d rotation = cv::Matx33d::eye();  ///< of the thing's axes, in the world
  cv::Vec3d position_m{};
};

/// Poses in the order of their times, no two of one time.
struct Trajectory {
  std::string format;  ///< "TUM", "KITTI", "EuRoC"
  bool timed = true;   ///< false: the file tells no times; stamps then count poses
  std::vector<TimedPose> poses;
  std::vector<std::string> remarks;  ///< what was left out or assumed
};

/// Reads a trajectory, told apart by its content: TUM (time tx ty tz qx qy qz qw a line, also with
/// commas), EuRoC's state_groundtruth (time in ns, px py pz qw qx qy qz, ...), KITTI (12 numbers a
/// line; times from `times`). Comments, blank lines, line ends of Windows and a mark of byte order
/// are passed over; lines that are no pose are left out and said, poses of one time but the first,
/// too.
/// @param times KITTI's times.txt; empty: none
/// @throws UserError where there is no pose at all, naming line and column of the first mistake
[[nodiscard]] Trajectory read_trajectory(const std::filesystem::path& file,
                                         const std::filesystem::path& times = {});
[[nodiscard]] Trajectory read_trajectory_text(const std::string& text, const std::string& name,
                                              const std::string& times = {});

/// Whether KITTI's poses get the times of their sequence.
enum class KittiTimes {
  read,     ///< where they lie as KITTI's do
  left_out  ///< poses are counted, as those of an estimate without times are
};

/// The ground truth of a data set's folder: EuRoC's, KITTI's (poses/NN.txt for sequences/NN), TUM's
/// groundtruth.txt; or a file of them. @throws UserError where there is none
[[nodiscard]] Trajectory find_ground_truth(const std::filesystem::path& path,
                                           KittiTimes times = KittiTimes::read);
/// The file that it would read; empty: there is none.
[[nodiscard]] std::filesystem::path ground_truth_file(const std::filesystem::path& path);

/// TUM's format, nine digits behind the point of the times.
[[nodiscard]] std::string tum_text(const std::vector<TimedPose>& poses);

/// x, y, z, w; w >= 0.
[[nodiscard]] cv::Vec4d quaternion_of(const cv::Matx33d& rotation);
[[nodiscard]] cv::Matx33d rotation_of(cv::Vec4d xyzw);

}  // namespace striate::datasets
