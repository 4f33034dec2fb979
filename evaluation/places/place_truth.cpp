#include "striate/evaluation/places/place_truth.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <map>
#include <numbers>
#include <opencv2/core.hpp>
#include <sstream>

#include "striate/base/files.hpp"
#include "striate/base/plain_text.hpp"
#include "striate/base/user_error.hpp"
#include "striate/evaluation/odometry/pose_pairs.hpp"
#include "striate/perception/visual_odometry/rigid_motion.hpp"

namespace striate::evaluation {
namespace {

constexpr const char* kLabelHeader = "image,place";

/// Without the line end of Windows.
bool next_line(std::istream& in, std::string& line) {
  if (!std::getline(in, line)) return false;
  if (!line.empty() && line.back() == '\r') line.pop_back();
  return true;
}

/// A mistake in a file of labels.
[[noreturn]] void refuse_label(const std::filesystem::path& file, int line,
                               const std::string& what) {
  throw UserError(
      fmt::format("{}:{}: {}\n    hint: a line is NAME,NUMBER or, of a place that is "
                  "seen but once, NAME,",
                  plain_text(file.string()), line, what));
}

std::optional<double> label_number(const std::string& text) {
  double number = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(number)) return {};
  return number;
}

}  // namespace

bool PlaceTruth::same(std::size_t a, std::size_t b) const {
  if (!poses_[a] || !poses_[b]) return false;
  if (cv::norm(poses_[a]->position_m - poses_[b]->position_m) > within_) return false;
  const cv::Vec3d turn_rad = perception::turn_of(poses_[a]->rotation.t() * poses_[b]->rotation);
  return cv::norm(turn_rad) <= within_rad_;
}

PlaceTruth PlaceTruth::of_trajectory(const datasets::Trajectory& trajectory,
                                     const std::vector<PlacedImage>& images,
                                     const PlaceTruthSettings& settings) {
  datasets::Trajectory asked;
  asked.timed = !images.empty() && images.front().stamp_ns.has_value();
  if (asked.timed != trajectory.timed) {
    throw UserError(trajectory.timed ? "the truth has times and the sequence has none"
                                     : "the truth has no times and the sequence has");
  }
  std::map<std::int64_t, std::size_t> image_at;
  for (std::size_t k = 0; k < images.size(); ++k) {
    const auto counted = static_cast<std::int64_t>(images[k].number) * 1'000'000'000;
    const std::int64_t stamp_ns = images[k].stamp_ns.value_or(counted);
    asked.poses.push_back({.stamp_ns = stamp_ns});
    image_at[stamp_ns] = k;
  }
  PlaceTruth truth(images.size(), settings.within_m,
                   settings.within_deg * std::numbers::pi / 180.0);
  for (const PosePair& pair : pair_poses(trajectory, asked, {}).pairs) {
    const std::size_t image = image_at.at(pair.estimate.stamp_ns);
    truth.told_[image] = 1;
    truth.poses_[image] = pair.truth;
  }
  return truth;
}

PlaceTruth PlaceTruth::of_labels(const std::filesystem::path& file,
                                 const std::vector<PlacedImage>& images,
                                 const PlaceTruthSettings& settings) {
  std::map<std::string, std::size_t> image_named;
  for (std::size_t k = 0; k < images.size(); ++k) image_named[images[k].name] = k;
  PlaceTruth truth(images.size(), settings.within_places, 0.0);
  std::istringstream in(read_file(file.string()));
  std::string line;
  std::size_t named = 0;
  next_line(in, line);  // is_place_labels() has seen it
  for (int number = 2; next_line(in, line); ++number) {
    if (line.empty() || line.front() == '#') continue;
    const std::size_t comma = line.rfind(',');
    if (comma == std::string::npos || comma == 0) refuse_label(file, number, "no name and place");
    const std::string place = line.substr(comma + 1);
    const std::optional<double> label = label_number(place);
    if (!place.empty() && !label) {
      refuse_label(file, number, fmt::format("\"{}\" is no number", plain_text(place)));
    }
    const auto image = image_named.find(line.substr(0, comma));
    if (image == image_named.end()) continue;  // the sequence may be a part
    ++named;
    truth.told_[image->second] = 1;
    if (label) truth.poses_[image->second] = datasets::TimedPose{.position_m = {*label, 0, 0}};
  }
  if (named > 0) return truth;
  throw UserError(fmt::format("{}: names no image of the sequence", plain_text(file.string())));
}

bool is_place_labels(const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) return false;
  std::istringstream in(read_file(file.string()));
  std::string line;
  return next_line(in, line) && line == kLabelHeader;
}

}  // namespace striate::evaluation
