#include <fmt/format.h>

#include "striate/base/user_error.hpp"
#include "striate/platform/datasets/trajectories/trajectory.hpp"

namespace striate::datasets {

namespace fs = std::filesystem;

Trajectory find_ground_truth(const fs::path& path) {
  std::error_code error;
  if (!fs::is_directory(path, error)) {
    if (!fs::exists(path, error)) {
      throw UserError(fmt::format("{}: there is no such file or folder", path.string()));
    }
    const fs::path times = path.parent_path() / "times.txt";
    const fs::path kitti =
        path.parent_path().parent_path() / "sequences" / path.stem() / "times.txt";
    for (const fs::path& one : {times, kitti}) {
      if (fs::is_regular_file(one, error)) return read_trajectory(path, one);
    }
    return read_trajectory(path);
  }
  const fs::path mav = fs::is_directory(path / "mav0", error) ? path / "mav0" : path;
  for (const char* name :
       {"state_groundtruth_estimate0", "groundtruth_left_camera", "gt0", "mocap0"}) {
    if (fs::exists(mav / name / "data.csv", error)) return read_trajectory(mav / name / "data.csv");
  }
  for (const char* name : {"groundtruth.txt", "groundtruth.tum", "gt.txt", "poses.txt"}) {
    if (!fs::exists(path / name, error)) continue;
    const fs::path times = path / "times.txt";
    return read_trajectory(path / name, fs::exists(times, error) ? times : fs::path());
  }
  const fs::path whole = fs::weakly_canonical(path, error);
  const fs::path kitti =
      whole.parent_path().parent_path() / "poses" / (whole.filename().string() + ".txt");
  if (fs::exists(kitti, error)) {
    const fs::path times = path / "times.txt";
    return read_trajectory(kitti, fs::exists(times, error) ? times : fs::path());
  }
  throw UserError(fmt::format(
      "{}: holds no ground truth\n    hint: EuRoC's mav0/state_groundtruth_estimate0/data.csv, "
      "KITTI's poses/NN.txt beside sequences/, TUM's groundtruth.txt; or give the file itself",
      path.string()));
}

}  // namespace striate::datasets
