#include "striate/evaluation/stereo_pairs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "striate/base/index_within.hpp"
#include "striate/base/user_error.hpp"
#include "striate/evaluation/images/pfm.hpp"
#include "striate/evaluation/images/set_files.hpp"
#include "striate/platform/datasets/images/read_image.hpp"

namespace striate::evaluation {
namespace {

namespace fs = std::filesystem;

/// px: no comparison with it holds, so it is never judged
constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();

struct Layout {
  const char* left;
  const char* right;
  const char* truth;
  const char* right_truth;  ///< may be missing
  const char* mask;         ///< may be missing
  double truth_per_px;
};
/// Names of images and truth in the Middlebury sets
constexpr std::array kLayouts = {
    Layout{"imL.png", "imR.png", "groundtruth.png", "", "nonocc.png", 4.0},
    Layout{"im2.png", "im6.png", "disp2.png", "disp6.png", "", 4.0},
    Layout{"view1.png", "view5.png", "disp1.png", "disp5.png", "", 3.0},
    Layout{"im0.png", "im1.png", "disp0.pfm", "disp1.pfm", "", 1.0},
    Layout{"left.png", "right.png", "disparity.pfm", "", "", 1.0},
};

fs::path if_there(const fs::path& folder, const char* file) {
  return *file != '\0' && fs::exists(folder / file) ? folder / file : fs::path();
}

/// Adds what the folder holds.
void look_into(const fs::path& folder, StereoFolders& found) {
  for (const Layout& layout : kLayouts) {
    const fs::path left = if_there(folder, layout.left), right = if_there(folder, layout.right);
    if (left.empty() || right.empty()) continue;
    const fs::path truth = if_there(folder, layout.truth);
    if (truth.empty()) {
      found.skipped.push_back(folder.string());
    } else {
      found.pairs.push_back({folder.filename().string(), left, right, truth,
                             if_there(folder, layout.right_truth), if_there(folder, layout.mask),
                             layout.truth_per_px});
    }
    return;
  }
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (!entry.path().filename().string().ends_with("_left.png")) continue;
    found.skipped.push_back(folder.string());
    return;
  }
}

cv::Mat1f read_truth(const fs::path& path, double per_px) {
  if (path.extension() == ".pfm") return read_pfm(path);
  cv::Mat1f result;
  read_values(path).convertTo(result, CV_32F, 1.0 / per_px);
  return result;
}

void require_same_size(const fs::path& path, cv::Size size, const fs::path& other,
                       cv::Size other_size) {
  if (size == other_size) return;
  auto text = [](cv::Size s) { return std::to_string(s.width) + "x" + std::to_string(s.height); };
  throw UserError(path.string() + " is " + text(size) + ", but " + other.filename().string() +
                  " is " + text(other_size));
}

/// The right eye's disparity as the left one's implies it: the nearest surface wins.
cv::Mat1f project_right(const cv::Mat1f& left) {
  cv::Mat1f right(left.size(), 0.0F);
  for (int y = 0; y < left.rows; ++y) {
    for (int x = 0; x < left.cols; ++x) {
      const float d = left(y, x);
      if (!std::isfinite(d) || d <= 0.0F || d > static_cast<float>(x)) continue;
      const int u = round_within(static_cast<float>(x) - d, 0, x);
      right(y, u) = std::max(right(y, u), d);
    }
  }
  return right;
}

/// A pixel is seen by both eyes if the right image's own disparity agrees within 1 px.
cv::Mat1f where_both_agree(const cv::Mat1f& left, const cv::Mat1f& right) {
  cv::Mat1f result(left.size(), kUnknown);
  for (int y = 0; y < left.rows; ++y) {
    for (int x = 0; x < left.cols; ++x) {
      const float d = left(y, x);
      if (!std::isfinite(d) || d <= 0.0F || d > static_cast<float>(x) + 0.5F) continue;
      const int u = round_within(static_cast<float>(x) - d, -1, x);
      if (u >= 0 && std::abs(right(y, u) - d) <= 1.0F) result(y, x) = d;
    }
  }
  return result;
}

cv::Mat1f judged_truth(const StereoFolder& folder, cv::Size size) {
  const cv::Mat1f left = read_truth(folder.truth, folder.truth_per_px);
  require_same_size(folder.truth, left.size(), folder.left, size);
  if (!folder.seen_by_both.empty()) {
    const cv::Mat1b seen = read_values(folder.seen_by_both);
    require_same_size(folder.seen_by_both, seen.size(), folder.left, size);
    cv::Mat1f truth = left.clone();
    truth.setTo(kUnknown, (seen != 255) | (truth <= 0.0F));
    return truth;
  }
  if (folder.right_truth.empty()) return where_both_agree(left, project_right(left));
  const cv::Mat1f right = read_truth(folder.right_truth, folder.truth_per_px);
  require_same_size(folder.right_truth, right.size(), folder.left, size);
  return where_both_agree(left, right);
}

}  // namespace

StereoFolders find_stereo_folders(const fs::path& root) {
  if (!fs::is_directory(root)) throw UserError(root.string() + ": there is no such folder");
  std::vector<fs::path> folders = {root};
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root)) {
    if (entry.is_directory()) folders.push_back(entry.path());
  }
  std::ranges::sort(folders);
  StereoFolders found;
  for (const fs::path& folder : folders) look_into(folder, found);
  return found;
}

StereoPair read_stereo_pair(const StereoFolder& folder, cv::Size size) {
  const auto [left, right] = datasets::read_grey_pair(folder.left, folder.right);
  const cv::Mat1f truth = judged_truth(folder, left.size());
  StereoPair pair;
  pair.name = folder.name;
  const auto shrink = [&](const cv::Mat1b& from, cv::Mat1b& whole, cv::Mat1w& fine) {
    cv::resize(from, whole, size, 0, 0, cv::INTER_AREA);
    cv::Mat1w sixteenths;
    from.convertTo(sixteenths, CV_16U, 16.0);
    cv::resize(sixteenths, fine, size, 0, 0, cv::INTER_AREA);
  };
  shrink(left, pair.left, pair.fine_left);
  shrink(right, pair.right, pair.fine_right);
  cv::resize(truth, pair.truth_px, size, 0, 0, cv::INTER_NEAREST);
  pair.truth_px *= static_cast<double>(size.width) / truth.cols;
  return pair;
}

}  // namespace striate::evaluation
