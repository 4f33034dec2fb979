#include "perception/descriptor/striate_descriptor.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

namespace striate {
namespace {

constexpr double kPixelsPerSize = 2.0;
constexpr int kPooledSide_px = 14;
/// With room for the cells' radius of 5 px: a patch never feels its neighbour.
constexpr int kSide_px = 24;
constexpr int kMargin_px = (kSide_px - kPooledSide_px) / 2;
constexpr int kPerRow = 16;
constexpr int kWeightSum = 1024;
constexpr int kSmallestLevel_px = 8;

struct Circle {
  int points;
  double radius_px, sigma_px, turn;
};
constexpr Circle kCircles[] = {
    {1, 0.0, 0.84, 0.0}, {6, 2.08, 0.91, 0.0}, {8, 4.05, 1.19, 0.5}, {10, 5.95, 1.54, 0.0}};

V1Settings v1_settings() {
  return {3.0, 0.3, 1.0, EvenMean::envelope};
}

double gaussian(double u, double v, double sigma) {
  const double value = std::exp(-(u * u + v * v) / (2.0 * sigma * sigma));
  return value < 0.03 ? 0.0 : value;
}

/// Bilinear; beyond the border the nearest pixel.
std::uint8_t sample(const cv::Mat1b& picture, double u, double v) {
  u = std::clamp(u, 0.0, picture.cols - 1.0);
  v = std::clamp(v, 0.0, picture.rows - 1.0);
  const int x = static_cast<int>(u), y = static_cast<int>(v);
  const int right = std::min(x + 1, picture.cols - 1), below = std::min(y + 1, picture.rows - 1);
  const double a = u - x, b = v - y;
  const double top = picture(y, x) * (1.0 - a) + picture(y, right) * a;
  const double bottom = picture(below, x) * (1.0 - a) + picture(below, right) * a;
  return static_cast<std::uint8_t>(top * (1.0 - b) + bottom * b + 0.5);
}

cv::Point corner(int patch) {
  return {patch % kPerRow * kSide_px, patch / kPerRow * kSide_px};
}

Descriptor bits_of(const PooledResponses& pooled, const StriateTable& table) {
  std::int64_t sum = 0;
  for (const std::int32_t value : pooled) sum += value;
  const std::int64_t mean = sum / kPooledValues;
  Descriptor descriptor;
  for (std::size_t b = 0; b < table.size(); ++b) {
    const std::int64_t difference = std::int64_t{pooled[static_cast<std::size_t>(table[b].first)]} -
                                    pooled[static_cast<std::size_t>(table[b].second)];
    const bool larger = difference * 1000 > mean * table[b].threshold;
    descriptor.words[b / 64] |= std::uint64_t{larger} << (b % 64);
  }
  return descriptor;
}

}  // namespace

StriateDescriber::StriateDescriber(const StriateSettings& settings)
    : settings_(settings), cells_(v1_settings()) {
  rectified_.resize(static_cast<std::size_t>(kPooledSide_px * kPooledSide_px * kPooledChannels));
  std::size_t at = 0;
  for (const Circle& circle : kCircles) {
    for (int k = 0; k < circle.points; ++k, ++at) {
      const double angle = 2.0 * std::numbers::pi * (k + circle.turn) / circle.points;
      auto weight = [&](int pixel) {
        constexpr double kMiddle = 0.5 * (kPooledSide_px - 1);
        return gaussian(pixel % kPooledSide_px - kMiddle - circle.radius_px * std::cos(angle),
                        pixel / kPooledSide_px - kMiddle - circle.radius_px * std::sin(angle),
                        circle.sigma_px);
      };
      double sum = 0.0;
      for (int p = 0; p < kPooledSide_px * kPooledSide_px; ++p) sum += weight(p);
      for (int p = 0; p < kPooledSide_px * kPooledSide_px; ++p) {
        const auto share = static_cast<std::int32_t>(std::lround(kWeightSum * weight(p) / sum));
        if (share > 0) weights_[at].push_back({p, share});
      }
    }
  }
}

void StriateDescriber::prepare(const cv::Mat1b& grey) {
  if (grey.empty()) throw std::invalid_argument("StriateDescriber: the picture is empty");
  if (halvings_.empty()) halvings_.resize(1);
  grey.copyTo(halvings_[0]);
  levels_ = 1;
  while (true) {
    const auto last = static_cast<std::size_t>(levels_ - 1);
    // An odd last row or column is left out: pixels must stay where they are.
    const cv::Size half(halvings_[last].cols / 2, halvings_[last].rows / 2);
    if (std::min(half.width, half.height) < kSmallestLevel_px) return;
    if (halvings_.size() == last + 1) halvings_.emplace_back();
    cv::resize(halvings_[last](cv::Rect({0, 0}, half * 2)), halvings_[last + 1], half, 0, 0,
               cv::INTER_AREA);
    ++levels_;
  }
}

/// All frames' surroundings as one picture, so that the V1 cells run once.
void StriateDescriber::resample(std::span<const DescribedFrame> frames) {
  if (levels_ == 0) throw std::invalid_argument("StriateDescriber: no picture was prepared");
  const int rows = (static_cast<int>(frames.size()) + kPerRow - 1) / kPerRow;
  patches_.create(rows * kSide_px, kPerRow * kSide_px);
  patches_ = std::uint8_t{128};
  for (std::size_t k = 0; k < frames.size(); ++k) {
    const DescribedFrame& frame = frames[k];
    if (!(frame.size_px > 0.0) ||
        !std::isfinite(frame.u_px + frame.v_px + frame.size_px + frame.angle_rad)) {
      throw std::invalid_argument("StriateDescriber: a frame has no size or no finite place");
    }
    const double step_px = frame.size_px / kPixelsPerSize;
    const long wanted = std::lround(std::log2(step_px));
    const int level = static_cast<int>(std::clamp(wanted, 0L, static_cast<long>(levels_) - 1));
    const double scale = std::ldexp(1.0, level);
    const double du = std::cos(frame.angle_rad) * step_px / scale;
    const double dv = std::sin(frame.angle_rad) * step_px / scale;
    const double u0 = (frame.u_px + 0.5) / scale - 0.5, v0 = (frame.v_px + 0.5) / scale - 0.5;
    const cv::Mat1b& picture = halvings_[static_cast<std::size_t>(level)];
    const cv::Point at = corner(static_cast<int>(k));
    for (int y = 0; y < kSide_px; ++y) {
      const double below = y - 0.5 * (kSide_px - 1);
      for (int x = 0; x < kSide_px; ++x) {
        const double along = x - 0.5 * (kSide_px - 1);
        patches_(at.y + y, at.x + x) =
            sample(picture, u0 + along * du - below * dv, v0 + along * dv + below * du);
      }
    }
  }
  cells_.respond(patches_, 0, true, responses_);
}

/// The sum of the odd responses as vectors across their orientation: where it grows brighter.
double StriateDescriber::dominant_angle_rad(int patch) const {
  const cv::Point at = corner(patch) + cv::Point(kMargin_px, kMargin_px);
  double u = 0.0, v = 0.0;
  for (std::size_t i = 0; i < kOrientations; ++i) {
    const double theta = static_cast<double>(i) * std::numbers::pi / kOrientations;
    double sum = 0.0;
    for (int y = 0; y < kPooledSide_px; ++y) {
      const std::int16_t* odd = responses_.odd[i].row(at.y + y) + at.x;
      for (int x = 0; x < kPooledSide_px; ++x) {
        constexpr double kMiddle = 0.5 * (kPooledSide_px - 1);
        sum += odd[x] * gaussian(x - kMiddle, y - kMiddle, 2.5);
      }
    }
    u += sum * std::cos(theta);
    v += sum * std::sin(theta);
  }
  return std::atan2(v, u);
}

void StriateDescriber::pool_patch(int patch, PooledResponses& out) {
  const cv::Point at = corner(patch) + cv::Point(kMargin_px, kMargin_px);
  for (std::size_t i = 0; i < kOrientations; ++i) {
    for (int y = 0; y < kPooledSide_px; ++y) {
      const std::int16_t* odd = responses_.odd[i].row(at.y + y) + at.x;
      std::int32_t* to = rectified_.data() + y * kPooledSide_px * kPooledChannels + i;
      for (int x = 0; x < kPooledSide_px; ++x, to += kPooledChannels) {
        to[0] = std::max<std::int32_t>(odd[x], 0);
        to[kOrientations] = std::max<std::int32_t>(-odd[x], 0);
      }
    }
  }
  for (std::size_t p = 0; p < weights_.size(); ++p) {
    std::array<std::int32_t, kPooledChannels> sum{};
    for (const Weight& w : weights_[p]) {
      const std::int32_t* from = rectified_.data() + w.pixel * kPooledChannels;
      for (std::size_t c = 0; c < sum.size(); ++c) sum[c] += w.weight * from[c];
    }
    std::ranges::copy(sum, out.begin() + static_cast<std::ptrdiff_t>(p) * kPooledChannels);
  }
}

void StriateDescriber::pool(std::span<const DescribedFrame> frames,
                            std::vector<PooledResponses>& out) {
  out.resize(frames.size());
  if (frames.empty()) return;
  if (settings_.orientation == StriateOrientation::given) {
    resample(frames);
  } else {
    turned_.assign(frames.begin(), frames.end());
    for (DescribedFrame& frame : turned_) frame.angle_rad = 0.0;
    resample(turned_);
    if (settings_.orientation == StriateOrientation::dominant) {
      for (std::size_t k = 0; k < turned_.size(); ++k) {
        turned_[k].angle_rad = dominant_angle_rad(static_cast<int>(k));
      }
      resample(turned_);
    }
  }
  for (std::size_t k = 0; k < frames.size(); ++k) pool_patch(static_cast<int>(k), out[k]);
}

void StriateDescriber::describe(std::span<const DescribedFrame> frames,
                                std::vector<Descriptor>& out) {
  pool(frames, pooled_);
  out.resize(frames.size());
  for (std::size_t k = 0; k < frames.size(); ++k) out[k] = bits_of(pooled_[k], settings_.table);
}

void StriateDescriber::describe(std::vector<Keypoint>& keypoints) {
  frames_.clear();
  for (const Keypoint& point : keypoints) {
    frames_.push_back({point.u_px, point.v_px, point.wavelength_px, 0.0});
  }
  describe(frames_, descriptors_);
  for (std::size_t k = 0; k < keypoints.size(); ++k) keypoints[k].descriptor = descriptors_[k];
}

}  // namespace striate
