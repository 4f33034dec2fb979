#include "striate/perception/stereo/pair_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "striate/perception/keypoints/keypoints.hpp"
#include "striate/perception/matching/hamming_search.hpp"

namespace striate::perception {
namespace {

/// Px: wide enough for corners a finger thick at 2 m, and looked at in a few milliseconds
constexpr int kCheckWidth_px = 480;
constexpr int kCheckPoints = 400;
/// Of the distance to the second nearest: a corner that looks like several others says nothing
constexpr double kDistinct = 0.75;
/// Bits of 256: descriptors of unlike places differ in 128
constexpr std::uint32_t kAlike_bits = 70;
/// With fewer corners chance decides (by hand)
constexpr std::size_t kFewestCorners = 20;

double middle_value(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

std::vector<Descriptor> descriptors_of(const std::vector<Keypoint>& points) {
  std::vector<Descriptor> descriptors;
  descriptors.reserve(points.size());
  for (const Keypoint& point : points) descriptors.push_back(point.descriptor);
  return descriptors;
}

/// The nearest of each, where it stands out; NearestTwo::kNone elsewhere.
std::vector<std::uint32_t> partners(const std::vector<Descriptor>& of,
                                    const std::vector<Descriptor>& among) {
  DescriptorStore store;
  store.append(among);
  HammingSearch search;
  std::vector<std::uint32_t> result;
  for (const NearestTwo& two : search.nearest_two(of, store)) {
    const bool good = two.first_bits <= kAlike_bits && two.first_bits < kDistinct * two.second_bits;
    result.push_back(good ? two.first : NearestTwo::kNone);
  }
  return result;
}

struct Medians {
  double down_px = 0.0;    ///< of all
  double spread_px = 0.0;  ///< of how far they are from it
};

Medians rows_of(const PairCheck& check) {
  std::vector<double> down;
  for (const PairCheck::Shift& shift : check.shifts) down.push_back(shift.down_px);
  Medians rows;
  rows.down_px = middle_value(down);
  for (double& value : down) value = std::abs(value - rows.down_px);
  rows.spread_px = middle_value(down);
  return rows;
}

template <class Is>
double share_of(const PairCheck& check, Is is) {
  const auto count = std::ranges::count_if(check.shifts, is);
  return static_cast<double>(count) / static_cast<double>(check.shifts.size());
}

/// Px: a corner's place errs by half of one in either image
constexpr double kClearly_px = 1.0;

double share_to_the_wrong_side(const PairCheck& check) {
  return share_of(check,
                  [](const PairCheck::Shift& shift) { return shift.left_px < -kClearly_px; });
}

}  // namespace

void PairCheck::add(const PairCheck& other) {
  shifts.insert(shifts.end(), other.shifts.begin(), other.shifts.end());
  width_px = other.width_px;
}

PairCheck check_pair(const cv::Mat1b& left, const cv::Mat1b& right) {
  PairCheck check;
  check.width_px = kCheckWidth_px;
  if (left.empty() || left.size() != right.size()) return check;
  const double scale = static_cast<double>(kCheckWidth_px) / left.cols;
  const cv::Size size(kCheckWidth_px,
                      std::max(16, static_cast<int>(std::lround(left.rows * scale))));
  KeypointSettings settings;
  settings.most = kCheckPoints;
  KeypointFinder finder(settings);
  const auto look = [&](const cv::Mat1b& image) {
    cv::Mat1b small;
    cv::resize(image, small, size, 0.0, 0.0, scale < 1.0 ? cv::INTER_AREA : cv::INTER_LINEAR);
    return finder.find(small);
  };
  const std::vector<Keypoint> in_left = look(left);
  const std::vector<Keypoint> in_right = look(right);
  if (in_left.empty() || in_right.empty()) return check;
  const std::vector<Descriptor> of_left = descriptors_of(in_left);
  const std::vector<Descriptor> of_right = descriptors_of(in_right);
  const std::vector<std::uint32_t> there = partners(of_left, of_right);
  const std::vector<std::uint32_t> back = partners(of_right, of_left);
  for (std::size_t i = 0; i < there.size(); ++i) {
    if (there[i] == NearestTwo::kNone || back[there[i]] != i) continue;
    const Keypoint& found = in_right[there[i]];
    check.shifts.push_back({in_left[i].u_px - found.u_px, found.v_px - in_left[i].v_px});
  }
  return check;
}

PairFault fault_of(const PairCheck& check) {
  constexpr double kSame_px = 0.05;  // a corner of one file is found where it was
  constexpr double kFlat_px = 0.3;   // ... and where two sensors' noise puts it
  /// Share of the corners: but for those that were found wrongly (by hand)
  constexpr double kNearlyAll = 0.9;
  constexpr double kMost = 0.75;  // of the corners: some are always wrong (by hand)
  /// Share that a toed-in camera with a far view may just have (by hand)
  constexpr double kMany = 0.3;
  constexpr double kFew = 0.1;  // share that is found wrongly even in a good pair (by hand)
  /// Half a pixel of the vision's 160: from there on matching suffers
  constexpr double kRows_px = 1.5;
  if (check.shifts.size() < kFewestCorners) return PairFault::unknown;
  const double same = share_of(check, [](const PairCheck::Shift& shift) {
    return std::hypot(shift.left_px, shift.down_px) < kSame_px;
  });
  if (same > kNearlyAll) return PairFault::same;
  const double near = share_of(
      check, [](const PairCheck::Shift& shift) { return std::abs(shift.left_px) > kClearly_px; });
  std::vector<double> aside;
  for (const PairCheck::Shift& shift : check.shifts) aside.push_back(std::abs(shift.left_px));
  if (near < kFew && middle_value(aside) < kFlat_px) return PairFault::flat;
  const double wrong_side = share_to_the_wrong_side(check);
  if (wrong_side > kMost) return PairFault::exchanged;
  const Medians rows = rows_of(check);
  if (rows.spread_px > kRows_px) return PairFault::unrectified;
  if (std::abs(rows.down_px) > kRows_px) return PairFault::rows;
  return wrong_side > kMany ? PairFault::behind : PairFault::none;
}

std::string fault_text(const PairCheck& check, double width_px) {
  const double scale = width_px / check.width_px;
  const auto percent = [&] { return std::lround(100.0 * share_to_the_wrong_side(check)); };
  switch (fault_of(check)) {
    case PairFault::none:
    case PairFault::unknown:
      break;
    case PairFault::same:
      return fmt::format(
          "left and right show the same picture: {} corners stand at the same place in both",
          check.shifts.size());
    case PairFault::flat:
      return fmt::format(
          "there is no depth in the pair: {} corners stand at the same place in both; it is one "
          "picture twice, or everything is very far away",
          check.shifts.size());
    case PairFault::exchanged:
      return fmt::format(
          "left and right seem to be exchanged: {} % of {} corners lie farther right in the right "
          "image than in the left one",
          percent(), check.shifts.size());
    case PairFault::rows:
      return fmt::format(
          "the right image lies {:.1f} px {} than the left one: rows must agree (the median of {} "
          "corners)",
          scale * std::abs(rows_of(check).down_px),
          rows_of(check).down_px > 0.0 ? "lower" : "higher", check.shifts.size());
    case PairFault::unrectified:
      return fmt::format(
          "the images are no rectified pair: corners lie {:.1f} px off their rows, here up and "
          "there down (the median of {})",
          scale * rows_of(check).spread_px, check.shifts.size());
    case PairFault::behind:
      return fmt::format(
          "{} % of {} corners lie beyond infinity: farther right in the right image than in the "
          "left one, so that the principal points of the two must differ",
          percent(), check.shifts.size());
  }
  return {};
}

std::string fault_hint(PairFault fault) {
  switch (fault) {
    case PairFault::none:
    case PairFault::unknown:
      break;
    case PairFault::same:
    case PairFault::flat:
      return "look where each eye's image comes from";
    case PairFault::exchanged:
      return "exchange the two; only where the principal points differ by much they are right, and "
             "the camera's numbers are not";
    case PairFault::rows:
      return "stereo moves the right image by up to three rows of its working image; better "
             "rectify "
             "the images, by a calibration of this camera as it is now";
    case PairFault::unrectified:
      return "rectify the images, by a calibration of this camera as it is now";
    case PairFault::behind:
      return "give the principal points of both eyes";
  }
  return {};
}

}  // namespace striate::perception
