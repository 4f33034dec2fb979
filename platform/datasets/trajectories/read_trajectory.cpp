#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

#include "striate/base/files.hpp"
#include "striate/base/plain_text.hpp"
#include "striate/base/user_error.hpp"
#include "striate/platform/datasets/calibration/text_tree.hpp"
#include "striate/platform/datasets/sequences/picture_list.hpp"
#include "striate/platform/datasets/trajectories/trajectory.hpp"

namespace striate::datasets {
namespace {

namespace fs = std::filesystem;

struct Word {
  std::string_view text;
  int column = 1;
};

bool parts_words(char c) {
  return c == ' ' || c == '\t' || c == ',' || c == ';';
}

std::vector<Word> words_of(std::string_view line) {
  std::vector<Word> words;
  for (std::size_t at = 0; at < line.size();) {
    if (parts_words(line[at])) {
      ++at;
      continue;
    }
    std::size_t end = at;
    while (end < line.size() && !parts_words(line[end])) ++end;
    words.push_back({line.substr(at, end - at), static_cast<int>(at) + 1});
    at = end;
  }
  return words;
}

/// A line that is a pose, or why it is none and where.
struct ReadLine {
  std::optional<TimedPose> pose;
  std::string why;
  int column = 1;
};

ReadLine no_pose(const std::string& why, int column) {
  return {std::nullopt, why, column};
}

/// Seconds with a point, as most write, or whole ns, as EuRoC does.
std::optional<std::int64_t> stamp_of(std::string_view text) {
  if (const auto exact = stamp_in_name(std::string(text))) return exact;
  const auto seconds = number_of(text);
  constexpr double kLatest_s = 9e9;      // s since 1970: the year 2255, where ns still fit 64 bits
  constexpr double kNs_at_least = 1e14;  // more can only be ns
  if (!seconds) return {};
  if (std::abs(*seconds) > kNs_at_least && std::abs(*seconds) < 9e18) {
    return static_cast<std::int64_t>(*seconds);
  }
  if (std::abs(*seconds) > kLatest_s) return {};
  return std::llround(1e9 * *seconds);
}

/// @param w_first EuRoC's order of a quaternion
ReadLine read_quaternion_line(const std::vector<Word>& words, bool w_first) {
  if (words.size() < 8) {
    return no_pose(fmt::format("a pose has a time and 7 numbers; here are {}", words.size()), 1);
  }
  const auto stamp_ns = stamp_of(words[0].text);
  if (!stamp_ns)
    return no_pose("the time is neither one in seconds nor one in ns", words[0].column);
  double n[7] = {};
  for (std::size_t k = 0; k < 7; ++k) {
    const auto value = number_of(words[k + 1].text);
    if (!value || std::abs(*value) > 1e9) {
      return no_pose(
          fmt::format("'{}' is no number of a pose", plain_text(words[k + 1].text.substr(0, 30))),
          words[k + 1].column);
    }
    n[k] = *value;
  }
  const cv::Vec4d q =
      w_first ? cv::Vec4d(n[4], n[5], n[6], n[3]) : cv::Vec4d(n[3], n[4], n[5], n[6]);
  constexpr double kUnit = 0.05;  // of a quaternion's length: files of two digits err less (ours)
  if (std::abs(cv::norm(q) - 1.0) > kUnit) {
    return no_pose(fmt::format("the quaternion has length {:.3f}, not 1", cv::norm(q)),
                   words[4].column);
  }
  return {TimedPose{*stamp_ns, rotation_of(q), {n[0], n[1], n[2]}}, "", 1};
}

ReadLine read_matrix_line(const std::vector<Word>& words) {
  double n[12] = {};
  if (words.size() != 12) {
    return no_pose(fmt::format("a pose of KITTI has 12 numbers; here are {}", words.size()), 1);
  }
  for (std::size_t k = 0; k < 12; ++k) {
    const auto value = number_of(words[k].text);
    if (!value || std::abs(*value) > 1e9) {
      return no_pose(
          fmt::format("'{}' is no number of a pose", plain_text(words[k].text.substr(0, 30))),
          words[k].column);
    }
    n[k] = *value;
  }
  TimedPose pose;
  pose.rotation = {n[0], n[1], n[2], n[4], n[5], n[6], n[8], n[9], n[10]};
  pose.position_m = {n[3], n[7], n[11]};
  const cv::Matx33d& r = pose.rotation;
  constexpr double kRotation = 0.02;  // of its numbers: as of calibrations (judge_model.cpp)
  if (cv::norm(r * r.t() - cv::Matx33d::eye(), cv::NORM_INF) > kRotation ||
      cv::determinant(r) < 0.0) {
    return no_pose("its nine numbers are no rotation", 1);
  }
  pose.rotation = rotation_of(quaternion_of(r));
  return {pose, "", 1};
}

enum class Format { tum, euroc, kitti };

/// By the first line that has numbers. EuRoC's have commas and whole times in ns.
std::optional<Format> format_of(const std::string& text) {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string_view line(text.data() + at, end - at);
    at = end + 1;
    const std::vector<Word> words = words_of(line);
    if (words.empty() || words[0].text.starts_with("#") || !number_of(words[0].text)) continue;
    if (words.size() == 12) return Format::kitti;
    if (words.size() < 8) continue;
    const bool ns = words[0].text.find_first_not_of("0123456789") == std::string_view::npos &&
                    words[0].text.size() > 14;
    return ns && line.find(',') != std::string_view::npos ? Format::euroc : Format::tum;
  }
  return {};
}

/// Sorted, each time once.
void put_in_order(Trajectory& trajectory) {
  const auto by_time = [](const TimedPose& a, const TimedPose& b) {
    return a.stamp_ns < b.stamp_ns;
  };
  if (!std::ranges::is_sorted(trajectory.poses, by_time)) {
    std::ranges::stable_sort(trajectory.poses, by_time);
    trajectory.remarks.emplace_back("its times go back: taken in the order of their times");
  }
  const std::size_t before = trajectory.poses.size();
  const auto [first, last] = std::ranges::unique(
      trajectory.poses,
      [](const TimedPose& a, const TimedPose& b) { return a.stamp_ns == b.stamp_ns; });
  trajectory.poses.erase(first, last);
  const std::size_t twice = before - trajectory.poses.size();
  if (twice > 0) {
    trajectory.remarks.push_back(
        fmt::format("{} poses have the time of another: the first of each counts", twice));
  }
}

std::vector<std::int64_t> read_times(const std::string& given, const std::string& name) {
  const std::string text = plain_line_ends(given);
  std::vector<std::int64_t> times_ns;
  int number = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::vector<Word> words = words_of({text.data() + at, end - at});
    at = end + 1;
    ++number;
    if (words.empty() || words[0].text.starts_with("#")) continue;
    const auto stamp_ns = stamp_of(words[0].text);
    if (!stamp_ns) {
      throw UserError(fmt::format("{}:{}:{}: '{}' is no time in seconds", name, number,
                                  words[0].column, plain_text(words[0].text.substr(0, 30))));
    }
    times_ns.push_back(*stamp_ns);
  }
  return times_ns;
}

}  // namespace

Trajectory read_trajectory_text(const std::string& given, const std::string& name,
                                const std::string& times) {
  const std::string text = plain_line_ends(given);
  const std::optional<Format> format = format_of(text);
  Trajectory trajectory;
  std::size_t left_out = 0;
  std::string first_mistake;
  int number = 0;
  const std::vector<std::int64_t> times_ns = read_times(times, "times");
  std::int64_t count = 0;
  for (std::size_t at = 0; at < text.size() && format;) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::vector<Word> words = words_of({text.data() + at, end - at});
    at = end + 1;
    ++number;
    if (words.empty() || words[0].text.starts_with("#")) continue;
    if (count == 0 && trajectory.poses.empty() && !number_of(words[0].text)) continue;  // a head
    ReadLine line = *format == Format::kitti
                        ? read_matrix_line(words)
                        : read_quaternion_line(words, *format == Format::euroc);
    const std::int64_t index = count++;  // a line that is left out still has its time
    if (!line.pose) {
      if (++left_out == 1) {
        first_mistake = fmt::format("{}:{}:{}: {}", name, number, line.column, line.why);
      }
      continue;
    }
    if (*format == Format::kitti) {
      const auto k = static_cast<std::size_t>(index);
      line.pose->stamp_ns = k < times_ns.size() ? times_ns[k] : index * 1'000'000'000;
    }
    trajectory.poses.push_back(*line.pose);
  }
  if (trajectory.poses.empty()) {
    throw UserError(fmt::format(
        "{}\n    hint: TUM (time tx ty tz qx qy qz qw), EuRoC's data.csv and KITTI (12 numbers a "
        "line) are read",
        first_mistake.empty() ? name + ": holds no trajectory" : first_mistake));
  }
  constexpr const char* kNames[] = {"TUM", "EuRoC", "KITTI"};
  trajectory.format = kNames[static_cast<int>(*format)];
  trajectory.timed = *format != Format::kitti || !times_ns.empty();
  if (left_out > 0) {
    trajectory.remarks.push_back(fmt::format("{} line{} no pose: left out; the first: {}", left_out,
                                             left_out == 1 ? " is" : "s are", first_mistake));
  }
  if (!times_ns.empty() && *format == Format::kitti &&
      times_ns.size() != static_cast<std::size_t>(count)) {
    if (times_ns.size() < static_cast<std::size_t>(count)) {
      throw UserError(
          fmt::format("{}: has {} poses, but there are {} times", name, count, times_ns.size()));
    }
    trajectory.remarks.push_back(fmt::format("there are {} times for {} poses: the first are taken",
                                             times_ns.size(), count));
  }
  put_in_order(trajectory);
  return trajectory;
}

Trajectory read_trajectory(const fs::path& file, const fs::path& times) {
  std::error_code error;
  for (const fs::path& one : {file, times}) {
    if (one.empty()) continue;
    if (!fs::is_regular_file(one, error)) {
      throw UserError(fmt::format("{}: there is no such file; give a trajectory", one.string()));
    }
    constexpr std::uintmax_t kMostTrajectory_bytes = 1U << 30;  // bytes: ten hours at 1 kHz
    if (fs::file_size(one, error) > kMostTrajectory_bytes) {
      throw UserError(fmt::format("{}: is larger than 1 GB", one.string()));
    }
  }
  return read_trajectory_text(read_file(file.string()), file.string(),
                              times.empty() ? "" : read_file(times.string()));
}

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
