#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string_view>

#include "striate/base/counted.hpp"
#include "striate/base/files.hpp"
#include "striate/base/plain_text.hpp"
#include "striate/base/user_error.hpp"
#include "striate/platform/datasets/calibration/text_tree.hpp"
#include "striate/platform/datasets/trajectories/pose_lines.hpp"
#include "striate/platform/datasets/trajectories/trajectory.hpp"

namespace striate::datasets {
namespace {

namespace fs = std::filesystem;

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
    trajectory.remarks.push_back(fmt::format(
        "{} with the time of another: the first of each counts", counted(twice, "pose")));
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
      throw UserError(fmt::format("{}: has {} for {}", name, counted(times_ns.size(), "time"),
                                  counted(static_cast<std::size_t>(count), "pose")));
    }
    trajectory.remarks.push_back(fmt::format("{} for {}: the first are taken",
                                             counted(times_ns.size(), "time"),
                                             counted(static_cast<std::size_t>(count), "pose")));
  }
  put_in_order(trajectory);
  return trajectory;
}

Trajectory read_trajectory(const fs::path& file, const fs::path& times) {
  std::error_code error;
  for (const fs::path& one : {file, times}) {
    if (one.empty()) continue;
    if (!fs::is_regular_file(one, error)) {
      throw UserError(fmt::format("{}: {}; give a trajectory", one.string(),
                                  fs::exists(one, error) ? "is no file" : "there is no such file"));
    }
    constexpr std::uintmax_t kMostTrajectory_bytes = 1U << 30;  // bytes: ten hours at 1 kHz
    if (fs::file_size(one, error) > kMostTrajectory_bytes) {
      throw UserError(fmt::format("{}: is larger than 1 GB", one.string()));
    }
  }
  return read_trajectory_text(read_file(file.string()), file.string(),
                              times.empty() ? "" : read_file(times.string()));
}

}  // namespace striate::datasets
