#include "striate/platform/simulator/render/camera_model.hpp"
#include "striate/platform/simulator/render/read_out_kernel.hpp"

namespace striate::simulator::render {
namespace {

constexpr int kMargin = Demosaic::kMargin;  // px around the mosaic that the demosaicing reads
/// Quantum efficiency behind the blue, green and red filter, relative to green.
constexpr std::array<float, 3> kFilter{0.62F, 1.0F, 0.72F};
/// Red and green on even rows, green and blue on odd ones: colour at (x, y).
constexpr int colour_at(int x, int y) {
  if (y % 2 == 0) return x % 2 == 0 ? 2 : 1;
  return x % 2 == 0 ? 1 : 0;
}

/// Moving average of a fractional length along lines of values, `step` apart.
class MovingAverage {
 public:
  explicit MovingAverage(float length_px) : reach_(static_cast<int>(std::ceil(length_px / 2.0F))) {
    float total = 0.0F;
    for (int k = -reach_; k <= reach_; ++k) {
      const float weight =
          std::min(1.0F, length_px / 2.0F + 0.5F - std::abs(static_cast<float>(k)));
      weights_.push_back(std::max(0.0F, weight));
      total += weights_.back();
    }
    share_ = 1.0F / total;
  }

  void smear(V4* first, std::ptrdiff_t step, int count) {
    const int padded = count + 2 * reach_;
    line_.resize(static_cast<std::size_t>(padded));
    for (int i = 0; i < padded; ++i) {
      line_[static_cast<std::size_t>(i)] = first[std::clamp(i - reach_, 0, count - 1) * step];
    }
    for (int i = 0; i < count; ++i) {
      V4 sum{};
      for (std::size_t k = 0; k < weights_.size(); ++k) {
        sum += line_[static_cast<std::size_t>(i) + k] * splat(weights_[k]);
      }
      first[i * step] = sum * splat(share_);
    }
  }

 private:
  int reach_;
  float share_ = 1.0F;
  std::vector<float> weights_;
  std::vector<V4> line_;
};

}  // namespace

Sensor::Sensor(const CameraSettings& settings, Eye eye, std::uint64_t seed, double common_pattern)
    : settings_(settings),
      width_(settings.width_px),
      height_(settings.height_px()),
      seed_(seed * 2 + (eye == Eye::left ? 0 : 1)),
      demosaic_(width_, height_) {
  const std::uint32_t pixels = key_of(seed_, 0xA11CE);
  const std::uint32_t of_both = key_of(seed, 0xB07F);
  const float half_diagonal =
      std::hypot(static_cast<float>(width_), static_cast<float>(height_)) / 2.0F;
  const double mismatch = (eye == Eye::left ? 0.5 : -0.5) * settings.gain_mismatch *
                          (key_of(seed, 0xBEEF) % 2 == 0 ? 1.0 : -1.0);
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) {
      const float r = std::hypot(static_cast<float>(x) - static_cast<float>(width_ - 1) / 2.0F,
                                 static_cast<float>(y) - static_cast<float>(height_ - 1) / 2.0F) /
                      half_diagonal;
      const float uneven = settings.noise
                               ? static_cast<float>(settings.non_uniformity) *
                                     gauss_(mix(pixels, static_cast<std::uint32_t>(y * width_ + x)))
                               : 0.0F;
      sensitivity_.push_back((1.0F - static_cast<float>(settings.vignetting) * r * r) *
                             (1.0F + uneven) * (1.0F + static_cast<float>(mismatch)));
      if (common_pattern > 0.0) {
        sensitivity_.back() *=
            1.0F + static_cast<float>(common_pattern) *
                       gauss_(mix(of_both, static_cast<std::uint32_t>(y * width_ + x)));
      }
    }
  }
  const int cells = (width_ + 2 * kMargin) * (height_ + 2 * kMargin);
  raw_.assign(static_cast<std::size_t>(cells) + Demosaic::kSlack, 0.0F);
}

cv::Mat3b Sensor::expose(const std::vector<V4>& light, const Exposure& exposure, const Smear& smear,
                         std::uint64_t frame) {
  blur_by_lens(light);
  if (smear.u_px > 0.3F) smear_rows(smear.u_px + 1.0F);
  if (smear.v_px > 0.3F) smear_columns(smear.v_px + 1.0F);
  read_out(exposure, frame);
  return demosaic_.image(raw_);
}

/// A lens is not sharper than the pixels: a cross-shaped point spread, which also keeps colours
/// from fringing in the mosaic. The border is not blurred.
void Sensor::blur_by_lens(const std::vector<V4>& light) {
  // Of a pixel's light to each of four neighbours: a lens no sharper than the pixels (ours)
  constexpr float kSpread = 0.09F;
  lens_.resize(light.size());
  for (int y = 0; y < height_; ++y) {
    const V4* in = light.data() + y * width_;
    V4* out = lens_.data() + y * width_;
    if (y == 0 || y + 1 == height_) {
      std::copy_n(in, width_, out);
      continue;
    }
    out[0] = in[0];
    for (int x = 1; x + 1 < width_; ++x) {
      const V4 around = in[x - 1] + in[x + 1] + in[x - width_] + in[x + width_];
      out[x] = in[x] * splat(1.0F - 4.0F * kSpread) + around * splat(kSpread);
    }
    out[width_ - 1] = in[width_ - 1];
  }
}

void Sensor::smear_rows(float length_px) {
  MovingAverage average(length_px);
  for (int y = 0; y < height_; ++y) average.smear(lens_.data() + y * width_, 1, width_);
}

void Sensor::smear_columns(float length_px) {
  MovingAverage average(length_px);
  for (int x = 0; x < width_; ++x) average.smear(lens_.data() + x, width_, height_);
}

void Sensor::read_out(const Exposure& exposure, std::uint64_t frame) {
  const auto full = static_cast<float>(settings_.full_well_e);
  const auto electrons =
      static_cast<float>(ExposureControl(settings_).sensitivity() * exposure.shutter_s) * full;
  const auto read_variance = static_cast<float>(settings_.read_noise_e * settings_.read_noise_e);
  const std::uint32_t key = key_of(seed_, frame);
  const int stride = width_ + 2 * kMargin;
  ReadOutRow row;
  row.electrons = electrons;
  row.full_well_e = full;
  row.read_variance_e2 = read_variance;
  row.noise = settings_.noise ? 1.0F : 0.0F;
  row.gain = static_cast<float>(exposure.gain);
  for (int y = 0; y < height_; ++y) {
    float* out = raw_.data() + (y + kMargin) * stride + kMargin;
    row.noise_key = mix(key, static_cast<std::uint32_t>(y));
    for (std::size_t odd = 0; odd < 2; ++odd) {
      row.colour[odd] = colour_at(static_cast<int>(odd), y);
      row.filter[odd] = kFilter[static_cast<std::size_t>(row.colour[odd])];
    }
    read_out_row(row, gauss_, lens_.data() + y * width_, sensitivity_.data() + y * width_, width_,
                 out);
    // Mirrored margins keep the mosaic's colours in step.
    out[-1] = out[1];
    out[-2] = out[2];
    out[width_] = out[width_ - 2];
    out[width_ + 1] = out[width_ - 3];
  }
  for (int k = 1; k <= kMargin; ++k) {
    const auto line = [&](int y) { return raw_.begin() + (y + kMargin) * stride; };
    std::copy_n(line(k), stride, line(-k));
    std::copy_n(line(height_ - 1 - k), stride, line(height_ - 1 + k));
  }
}

}  // namespace striate::simulator::render
