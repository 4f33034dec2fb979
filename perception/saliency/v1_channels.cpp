#include "striate/perception/saliency/v1_channels.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <opencv2/imgproc.hpp>

#include "striate/perception/keypoints/end_stopped_kernels.hpp"
#include "striate/perception/saliency/gaussian.hpp"

namespace striate::perception {
namespace {

/// Px of the working size; four times cheaper than half, at no loss of AUC (tests/evaluation)
constexpr int kBlock = 4;

/// Mirrored with the border pixel repeated, as cv::BORDER_REFLECT.
int mirror_with_border(int i, int n) {
  while (i < 0 || i >= n) i = i < 0 ? -i - 1 : 2 * n - 1 - i;
  return i;
}

/// out += min(energy(p + n), energy(p - n)) at every pixel p.
void add_facing(const cv::Mat1f& energy, cv::Point n, cv::Mat1f& out) {
  const int width = energy.cols;
  const int inner_from = std::min(std::abs(n.x), width);
  const int inner_to = std::max(inner_from, width - std::abs(n.x));
  for (int v = 0; v < energy.rows; ++v) {
    const float* ahead = energy[mirror_with_border(v + n.y, energy.rows)];
    const float* behind = energy[mirror_with_border(v - n.y, energy.rows)];
    float* to = out[v];
    const auto at_border = [&](int u) {
      to[u] += std::min(ahead[mirror_with_border(u + n.x, width)],
                        behind[mirror_with_border(u - n.x, width)]);
    };
    for (int u = 0; u < inner_from; ++u) at_border(u);
    for (int u = inner_from; u < inner_to; ++u) to[u] += std::min(ahead[u + n.x], behind[u - n.x]);
    for (int u = inner_to; u < width; ++u) at_border(u);
  }
}

}  // namespace

cv::Size quarter_of(cv::Size working) {
  return {(working.width + kBlock - 1) / kBlock, (working.height + kBlock - 1) / kBlock};
}

void V1Channels::average(const V1Responses& v1) {
  constexpr std::size_t kSlack = 64;  // vector stores run over the end
  const cv::Size size = quarter_of({v1.width, v1.height});
  amplitudes_.resize(static_cast<std::size_t>(v1.width) + kSlack);
  sums_.resize(static_cast<std::size_t>(size.width));
  for (std::size_t i = 0; i < energy_.size(); ++i) {
    energy_[i].create(size);
    for (int v = 0; v < size.height; ++v) {
      const int rows = std::min(kBlock, v1.height - kBlock * v);
      std::fill(sums_.begin(), sums_.end(), 0U);
      for (int k = 0; k < rows; ++k) {
        end_stopped_kernels::amplitudes(v1.code[i].row(kBlock * v + k), v1.width,
                                        amplitudes_.data());
        for (int u = 0; u < v1.width; ++u)
          sums_[static_cast<std::size_t>(u / kBlock)] += amplitudes_[static_cast<std::size_t>(u)];
      }
      for (int u = 0; u < size.width; ++u) {
        const int pixels = rows * std::min(kBlock, v1.width - kBlock * u);
        energy_[i](v, u) = static_cast<float>(sums_[static_cast<std::size_t>(u)]) /
                           static_cast<float>(pixels * v1.gain);
      }
    }
  }
}

void V1Channels::texture(cv::Mat1f& out) {
  // Narrow and wide, of both scales.
  static const std::array<std::array<Gaussian, 2>, 2> kScales{
      {{Gaussian(1.0), Gaussian(3.0)}, {Gaussian(2.0), Gaussian(6.0)}}};
  cv::merge(energy_.data(), energy_.size(), all_);
  out.create(all_.size());
  out.setTo(0.0F);
  for (const auto& scale : kScales) {
    scale[0].blur(all_, narrow_);
    scale[1].blur(all_, wide_);
    for (int v = 0; v < out.rows; ++v) {
      const auto* narrow = narrow_.ptr<float>(v);
      const auto* wide = wide_.ptr<float>(v);
      for (int u = 0; u < out.cols; ++u) {
        float sum = 0.0F;
        for (int i = 0; i < kOrientations; ++i) {
          sum += std::max(0.0F, narrow[kOrientations * u + i] - wide[kOrientations * u + i]);
        }
        out(v, u) += sum;
      }
    }
  }
}

void V1Channels::shape(cv::Mat1f& out) const {
  out.create(energy_[0].size());
  out.setTo(0.0F);
  for (std::size_t i = 0; i < energy_.size(); ++i) {
    const double theta = static_cast<double>(i) * std::numbers::pi / kOrientations;
    for (const double radius_px : {2.0, 4.0, 6.0}) {
      add_facing(energy_[i],
                 {static_cast<int>(std::lround(radius_px * std::cos(theta))),
                  static_cast<int>(std::lround(radius_px * std::sin(theta)))},
                 out);
    }
  }
}

}  // namespace striate::perception
