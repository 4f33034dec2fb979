#pragma once

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

/// Public stereo pairs with ground truth, brought to one working size.
namespace striate::reference {

struct StereoPair {
  std::string name;
  cv::Mat1b left, right;            ///< 8 bits
  cv::Mat1w fine_left, fine_right;  ///< the same in sixteenths of a grey level
  cv::Mat1f truth_px;  ///< disparity at the working size; NaN: unknown or not seen by the right eye
};

/// The public data: what the environment says, else what the build was told.
inline std::string shared_data(const std::string& built_with) {
  const char* folder = std::getenv("STRIATE_SHARED_DATA");
  return folder != nullptr ? folder : built_with;
}

namespace detail {

/// A pixel is seen by both eyes if the right picture's own disparity agrees within 1 px.
inline cv::Mat1f seen_by_both(const cv::Mat1f& left, const cv::Mat1f& right) {
  cv::Mat1f result(left.size(), std::numeric_limits<float>::quiet_NaN());
  for (int y = 0; y < left.rows; ++y) {
    for (int x = 0; x < left.cols; ++x) {
      const float d = left(y, x);
      const int u = static_cast<int>(std::lround(static_cast<float>(x) - d));
      if (d > 0 && u >= 0 && std::abs(right(y, u) - d) <= 1.0F) result(y, x) = d;
    }
  }
  return result;
}

/// The right eye's disparity as the left one's implies it: the nearest surface wins.
inline cv::Mat1f project_right(const cv::Mat1f& left) {
  cv::Mat1f right(left.size(), 0.0F);
  for (int y = 0; y < left.rows; ++y) {
    for (int x = 0; x < left.cols; ++x) {
      const float d = left(y, x);
      if (!std::isfinite(d) || d <= 0) continue;
      const int u = static_cast<int>(std::lround(static_cast<float>(x) - d));
      if (u >= 0) right(y, u) = std::max(right(y, u), d);
    }
  }
  return right;
}

inline cv::Mat1f read_scaled(const std::filesystem::path& path, float divisor) {
  const cv::Mat grey = cv::imread(path.string(), cv::IMREAD_GRAYSCALE);
  cv::Mat1f result;
  grey.convertTo(result, CV_32F, 1.0 / divisor);
  return result;
}

/// A PFM file; rows come bottom up.
inline cv::Mat1f read_pfm(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string kind;
  int width = 0, height = 0;
  double scale = 0.0;
  file >> kind >> width >> height >> scale;
  file.get();
  cv::Mat1f result(height, width);
  for (int y = height - 1; y >= 0; --y) {
    file.read(reinterpret_cast<char*>(result.ptr(y)), width * static_cast<int>(sizeof(float)));
  }
  return result;
}

inline StereoPair make_pair(const std::string& name, const std::filesystem::path& left,
                            const std::filesystem::path& right, const cv::Mat1f& truth,
                            cv::Size size) {
  StereoPair pair;
  pair.name = name;
  const cv::Mat1b full_left = cv::imread(left.string(), cv::IMREAD_GRAYSCALE);
  const cv::Mat1b full_right = cv::imread(right.string(), cv::IMREAD_GRAYSCALE);
  cv::resize(full_left, pair.left, size, 0, 0, cv::INTER_AREA);
  cv::resize(full_right, pair.right, size, 0, 0, cv::INTER_AREA);
  const auto shrink_fine = [&](const cv::Mat1b& from, cv::Mat1w& to) {
    cv::Mat1w sixteenths;
    from.convertTo(sixteenths, CV_16U, 16.0);
    cv::resize(sixteenths, to, size, 0, 0, cv::INTER_AREA);
  };
  shrink_fine(full_left, pair.fine_left);
  shrink_fine(full_right, pair.fine_right);
  cv::resize(truth, pair.truth_px, size, 0, 0, cv::INTER_NEAREST);
  pair.truth_px *= static_cast<double>(size.width) / truth.cols;
  return pair;
}

}  // namespace detail

/// All pairs below `folder` (the shared stereo data); empty where there are none.
inline std::vector<StereoPair> load_stereo_pairs(const std::filesystem::path& folder,
                                                 cv::Size size) {
  using namespace detail;
  std::vector<StereoPair> pairs;
  for (const std::string name : {"teddy", "cones"}) {
    const auto at = folder / "middlebury_2003" / name;
    if (!std::filesystem::exists(at / "groundtruth.png")) continue;
    cv::Mat1f truth = read_scaled(at / "groundtruth.png", 4.0F);
    const cv::Mat1b seen = cv::imread((at / "nonocc.png").string(), cv::IMREAD_GRAYSCALE);
    truth.setTo(std::numeric_limits<float>::quiet_NaN(), (seen != 255) | (truth <= 0.0F));
    pairs.push_back(make_pair(name, at / "imL.png", at / "imR.png", truth, size));
  }
  for (const std::string name : {"Aloe", "Baby1", "Bowling1", "Cloth1", "Flowerpots", "Lampshade1",
                                 "Midd1", "Plastic", "Rocks1", "Wood1"}) {
    const auto at = folder / "middlebury_2006" / name;
    if (!std::filesystem::exists(at / "disp1.png")) continue;
    const cv::Mat1f truth =
        seen_by_both(read_scaled(at / "disp1.png", 3.0F), read_scaled(at / "disp5.png", 3.0F));
    pairs.push_back(make_pair(name, at / "view1.png", at / "view5.png", truth, size));
  }
  const auto at = folder / "motorcycle";
  if (std::filesystem::exists(at / "disparity.pfm")) {
    const cv::Mat1f left = read_pfm(at / "disparity.pfm");
    pairs.push_back(make_pair("motorcycle", at / "left.png", at / "right.png",
                              seen_by_both(left, project_right(left)), size));
  }
  return pairs;
}

struct StereoScore {
  double bad1 = 0.0;     ///< % of judged pixels that are wrong by more than 1 px
  double bad2 = 0.0;     ///< ... 2 px
  double density = 0.0;  ///< % of pixels with known truth that have a disparity
};

/// Judges finite disparities at pixels that both eyes see.
inline StereoScore judge(const cv::Mat1f& disparity_px, const cv::Mat1f& truth_px) {
  int known = 0, judged = 0, wrong1 = 0, wrong2 = 0;
  for (int y = 0; y < truth_px.rows; ++y) {
    for (int x = 0; x < truth_px.cols; ++x) {
      if (!std::isfinite(truth_px(y, x))) continue;
      ++known;
      if (!std::isfinite(disparity_px(y, x))) continue;
      ++judged;
      const float error = std::abs(disparity_px(y, x) - truth_px(y, x));
      wrong1 += error > 1.0F;
      wrong2 += error > 2.0F;
    }
  }
  const double share = 100.0 / std::max(1, judged);
  return {wrong1 * share, wrong2 * share, 100.0 * judged / std::max(1, known)};
}

}  // namespace striate::reference
