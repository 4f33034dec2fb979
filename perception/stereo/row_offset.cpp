#include "striate/perception/stereo/row_offset.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <opencv2/core.hpp>
#include <vector>

#include "striate/base/index_within.hpp"
#include "striate/perception/stereo/cubic_weights.hpp"

namespace striate::perception {
namespace {

constexpr float kSureMatch = 0.75F;  // confidence: of such, nine in ten are right
/// Change from row to row, of the largest grey: two levels of 255, above what noise makes
constexpr float kLeastFall = 2.0F / 255.0F;
/// On a level edge the grey changes mostly from row to row: at least this many times as much as it
/// does from column to column. On a steeper edge the disparity takes up the offset.
constexpr float kLevelness = 2.0F;
constexpr int kFewestPixels =
    150;  // pixels on such edges, of which nearly half may be wrong (ours)
/// Offsets are told apart in steps of 1/64 row, to two rows each way
constexpr int kSteps = 64;
constexpr int kMostSteps = 2 * kSteps;
/// Offsets that the means of rows are tried with, each way ...
constexpr int kMostRows = 4;
/// ... by how much their correlation must be better than without any (ours) ...
constexpr double kClearlyBetter = 0.1;
/// ... and how good: of two noises it is 0.35 at most (nine offsets of 119 rows)
constexpr double kLeastLikeness = 0.5;

/// One pixel of both eyes, the right one at the left one's disparity; greys 0 .. 1.
struct EdgePixel {
  float difference = 0.0F;  ///< left minus right
  float right = 0.0F;
  float left = 0.0F;
  float down = 0.0F;  ///< change from row to row, mean of both eyes
};

template <class Grey>
class LevelEdges {
 public:
  LevelEdges(const cv::Mat& left, const cv::Mat& right, float white)
      : left_(left), right_(right), scale_(1.0F / white) {}

  /// Pixels on level edges where the match is sure.
  [[nodiscard]] std::vector<EdgePixel> find(const DisparityMap& matched) const {
    std::vector<EdgePixel> pixels;
    for (int y = 1; y + 1 < left_.rows; ++y) {
      const float* disparities = matched.disparity_px[y];
      const float* confidences = matched.confidence[y];
      const Grey* here = left_.ptr<Grey>(y);
      for (int x = 1; x + 1 < left_.cols; ++x) {
        if (confidences[x] < kSureMatch) continue;
        const float at = static_cast<float>(x) - disparities[x];
        if (!(at >= 0.0F && at < static_cast<float>(left_.cols - 1))) continue;
        EdgePixel pixel;
        pixel.down = 0.25F * (grey(left_, y + 1, x) - grey(left_, y - 1, x) + between(y + 1, at) -
                              between(y - 1, at));
        const float across = 0.5F * scale_ * static_cast<float>(here[x + 1] - here[x - 1]);
        if (std::abs(pixel.down) < std::max(kLeastFall, kLevelness * std::abs(across))) continue;
        pixel.left = grey(left_, y, x);
        pixel.right = between(y, at);
        pixels.push_back(pixel);
      }
    }
    return pixels;
  }

 private:
  [[nodiscard]] float grey(const cv::Mat& image, int y, int x) const {
    return scale_ * static_cast<float>(image.ptr<Grey>(y)[x]);
  }
  [[nodiscard]] float between(int y, float x) const {
    const int x0 = static_cast<int>(x);
    const float share = x - static_cast<float>(x0);
    return grey(right_, y, x0) * (1.0F - share) + grey(right_, y, x0 + 1) * share;
  }

  const cv::Mat& left_;
  const cv::Mat& right_;
  float scale_;
};

/// Another exposure of the right eye is no offset: brings mean and spread to the left one's.
void balance_eyes(std::vector<EdgePixel>& pixels) {
  double left = 0.0, right = 0.0, left_square = 0.0, right_square = 0.0;
  for (const EdgePixel& s : pixels) {
    left += s.left;
    right += s.right;
    left_square += s.left * s.left;
    right_square += s.right * s.right;
  }
  const auto n = static_cast<double>(pixels.size());
  const double left_spread = left_square / n - left * left / n / n;
  const double right_spread = right_square / n - right * right / n / n;
  const double gain = right_spread > 0.0 ? std::sqrt(std::max(0.0, left_spread) / right_spread) : 1;
  for (EdgePixel& s : pixels) {
    s.difference = static_cast<float>(s.left - left / n - gain * (s.right - right / n));
  }
}

/// The median of difference / down, each with the weight of its change: half of them may be wrong.
double median_offset(const std::vector<EdgePixel>& pixels) {
  std::array<double, 2 * kMostSteps + 1> weights{};
  double all = 0.0;
  for (const EdgePixel& s : pixels) {
    const double offset = s.difference / s.down;
    const int step = round_within(offset * kSteps, -kMostSteps, kMostSteps);
    weights[static_cast<std::size_t>(step + kMostSteps)] += std::abs(s.down);
    all += std::abs(s.down);
  }
  double before = 0.0;
  int step = -kMostSteps;
  for (const double weight : weights) {
    before += weight;
    if (2.0 * before >= all) break;
    ++step;
  }
  return static_cast<double>(step) / kSteps;
}

/// How the mean of a row differs from the next one's.
std::vector<double> falls_of_means(const cv::Mat& image) {
  cv::Mat1d means;
  cv::reduce(image, means, 1, cv::REDUCE_AVG, CV_64F);
  std::vector<double> falls;
  for (int y = 0; y + 1 < means.rows; ++y) falls.push_back(means(y + 1, 0) - means(y, 0));
  return falls;
}

/// Of the left rows with the right ones so many rows below, normalised; 0 where either is even.
double correlation(const std::vector<double>& left, const std::vector<double>& right, int rows) {
  double both = 0.0, of_left = 0.0, of_right = 0.0;
  const int count = static_cast<int>(left.size());
  for (int y = std::max(0, -rows); y < count - std::max(0, rows); ++y) {
    const double l = left[static_cast<std::size_t>(y)];
    const double r = right[static_cast<std::size_t>(y + rows)];
    both += l * r;
    of_left += l * l;
    of_right += r * r;
  }
  return of_left > 0.0 && of_right > 0.0 ? both / std::sqrt(of_left * of_right) : 0.0;
}

template <class Grey>
void raise_all_rows(const cv::Mat& image, int sixteenths, cv::Mat& out) {
  const int whole =
      floor_within(static_cast<double>(sixteenths) / kCubicParts, -image.rows, image.rows);
  const std::array<int, 4> weights = cubic_weights(sixteenths - whole * kCubicParts);
  const int white = image.depth() == CV_8U ? 255 : kWhitestFine;
  for (int y = 0; y < image.rows; ++y) {
    std::array<const Grey*, 4> rows{};
    for (int k = 0; k < 4; ++k) {
      rows[static_cast<std::size_t>(k)] =
          image.ptr<Grey>(std::clamp(y + whole - 1 + k, 0, image.rows - 1));
    }
    auto* to = out.ptr<Grey>(y);
    for (int x = 0; x < image.cols; ++x) {
      int sum = kCubicOne / 2;
      for (std::size_t k = 0; k < 4; ++k) sum += weights[k] * rows[k][x];
      to[x] = static_cast<Grey>(std::clamp(sum / kCubicOne, 0, white));
    }
  }
}

}  // namespace

double row_offset_px(const cv::Mat& left, const cv::Mat& right, const DisparityMap& matched) {
  const bool bytes = left.depth() == CV_8U;
  std::vector<EdgePixel> pixels =
      bytes ? LevelEdges<std::uint8_t>(left, right, 255.0F).find(matched)
            : LevelEdges<std::uint16_t>(left, right, 16.0F * 255.0F).find(matched);
  if (pixels.size() < static_cast<std::size_t>(kFewestPixels)) return 0.0;
  balance_eyes(pixels);
  return median_offset(pixels);
}

double row_offset_of_means_px(const cv::Mat& left, const cv::Mat& right) {
  const std::vector<double> l = falls_of_means(left), r = falls_of_means(right);
  std::array<double, 2 * kMostRows + 1> likeness{};
  for (int rows = -kMostRows; rows <= kMostRows; ++rows) {
    likeness[static_cast<std::size_t>(rows + kMostRows)] = correlation(l, r, rows);
  }
  const auto best = std::ranges::max_element(likeness);
  const int rows = static_cast<int>(best - likeness.begin()) - kMostRows;
  if (*best < std::max(kLeastLikeness, likeness[kMostRows] + kClearlyBetter) ||
      std::abs(rows) == kMostRows)
    return 0.0;
  const double curvature = best[-1] - 2.0 * *best + best[1];  // below 0: the largest
  return rows + 0.5 * (best[-1] - best[1]) / curvature;
}

cv::Mat raised(const cv::Mat& image, double rows_px) {
  cv::Mat out(image.size(), image.type());
  const int most = kCubicParts * image.rows;
  const int sixteenths = round_within(rows_px * kCubicParts, -most, most);
  if (image.depth() == CV_8U) {
    raise_all_rows<std::uint8_t>(image, sixteenths, out);
  } else {
    raise_all_rows<std::uint16_t>(image, sixteenths, out);
  }
  return out;
}

}  // namespace striate::perception
