#include "striate/platform/datasets/trajectories/pose_lines.hpp"

#include <fmt/format.h>

#include <cmath>

#include "striate/base/plain_text.hpp"
#include "striate/platform/datasets/calibration/text_tree.hpp"
#include "striate/platform/datasets/sequences/picture_list.hpp"

namespace striate::datasets {
namespace {

bool parts_words(char c) {
  return c == ' ' || c == '\t' || c == ',' || c == ';';
}

ReadLine no_pose(const std::string& why, int column) {
  return {std::nullopt, why, column};
}

}  // namespace

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

}  // namespace striate::datasets
