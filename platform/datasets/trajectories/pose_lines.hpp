#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "striate/platform/datasets/trajectories/trajectory.hpp"

/// One line of somebody's trajectory.
namespace striate::datasets {

struct Word {
  std::string_view text;
  int column = 1;
};

/// Parted by blanks, commas and semicolons; they point into the line.
[[nodiscard]] std::vector<Word> words_of(std::string_view line);

/// A line that is a pose, or why it is none and where.
struct ReadLine {
  std::optional<TimedPose> pose;
  std::string why;
  int column = 1;
};

/// Seconds with a point, as most write, or whole ns, as EuRoC does.
[[nodiscard]] std::optional<std::int64_t> stamp_of(std::string_view text);

/// TUM's and EuRoC's. @param w_first EuRoC's order of a quaternion
[[nodiscard]] ReadLine read_quaternion_line(const std::vector<Word>& words, bool w_first);

/// KITTI's twelve numbers, without a time.
[[nodiscard]] ReadLine read_matrix_line(const std::vector<Word>& words);

}  // namespace striate::datasets
