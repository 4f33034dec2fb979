#include <fmt/format.h>

#include <optional>

#include "striate/base/user_error.hpp"
#include "striate/platform/datasets/trajectories/trajectory.hpp"

namespace striate::datasets {

namespace fs = std::filesystem;

namespace {

struct TruthFiles {
  fs::path poses;
  fs::path times;  ///< KITTI's; empty: none, or not needed
};

fs::path if_there(const fs::path& file) {
  std::error_code error;
  return fs::exists(file, error) ? file : fs::path();
}

TruthFiles beside_file(const fs::path& path) {
  std::error_code error;
  const fs::path times = path.parent_path() / "times.txt";
  const fs::path kitti = path.parent_path().parent_path() / "sequences" / path.stem() / "times.txt";
  for (const fs::path& one : {times, kitti}) {
    if (fs::is_regular_file(one, error)) return {path, one};
  }
  return {path, {}};
}

/// Nothing where the folder holds none.
std::optional<TruthFiles> in_folder(const fs::path& path) {
  std::error_code error;
  const fs::path mav = fs::is_directory(path / "mav0", error) ? path / "mav0" : path;
  for (const char* name :
       {"state_groundtruth_estimate0", "groundtruth_left_camera", "gt0", "mocap0"}) {
    if (fs::exists(mav / name / "data.csv", error)) return TruthFiles{mav / name / "data.csv", {}};
  }
  for (const char* name : {"groundtruth.txt", "groundtruth.tum", "gt.txt", "poses.txt"}) {
    if (fs::exists(path / name, error)) {
      return TruthFiles{path / name, if_there(path / "times.txt")};
    }
  }
  const fs::path whole = fs::weakly_canonical(path, error);
  const fs::path kitti =
      whole.parent_path().parent_path() / "poses" / (whole.filename().string() + ".txt");
  if (fs::exists(kitti, error)) return TruthFiles{kitti, if_there(path / "times.txt")};
  return std::nullopt;
}

Trajectory read_truth_files(const TruthFiles& files, KittiTimes times) {
  return read_trajectory(files.poses, times == KittiTimes::read ? files.times : fs::path());
}

}  // namespace

fs::path ground_truth_file(const fs::path& path) {
  std::error_code error;
  if (!fs::is_directory(path, error)) return if_there(path);
  const auto found = in_folder(path);
  return found ? found->poses : fs::path();
}

Trajectory find_ground_truth(const fs::path& path, KittiTimes times) {
  std::error_code error;
  if (!fs::is_directory(path, error)) {
    if (!fs::exists(path, error)) {
      throw UserError(fmt::format("{}: there is no such file or folder", path.string()));
    }
    return read_truth_files(beside_file(path), times);
  }
  if (const auto found = in_folder(path)) return read_truth_files(*found, times);
  throw UserError(fmt::format(
      "{}: holds no ground truth\n    hint: EuRoC's mav0/state_groundtruth_estimate0/data.csv, "
      "KITTI's poses/NN.txt beside sequences/, TUM's groundtruth.txt; or give the file itself",
      path.string()));
}

}  // namespace striate::datasets
