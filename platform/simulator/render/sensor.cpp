#include "platform/simulator/render/camera_model.hpp"

namespace striate::simulator::render {
namespace {

constexpr int kMargin = 2;
/// Quantum efficiency behind the blue, green and red filter, relative to green.
constexpr std::array<float, 3> kFilter{0.62F, 1.0F, 0.72F};
/// Red and green on even rows, green and blue on odd ones: colour at (x, y).
constexpr int colour_at(int x, int y) {
  if (y % 2 == 0) return x % 2 == 0 ? 2 : 1;
  return x % 2 == 0 ? 1 : 0;
}

std::vector<std::uint8_t> tone_curve() {
  std::vector<std::uint8_t> curve(4096);
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const double x = static_cast<double>(i) / 4095.0;
    const double y = x < 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1.0 / 2.4) - 0.055;
    curve[i] = static_cast<std::uint8_t>(255.0 * y + 0.5);
  }
  return curve;
}

/// Moving average of a fractional length over `count` values, `step` apart.
void average(V4* first, std::ptrdiff_t step, int count, float length_px, std::vector<V4>& line) {
  line.resize(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) line[static_cast<std::size_t>(i)] = first[i * step];
  const int reach = static_cast<int>(std::ceil(length_px / 2.0F));
  for (int i = 0; i < count; ++i) {
    V4 sum{};
    float weights = 0.0F;
    for (int k = -reach; k <= reach; ++k) {
      const float weight =
          std::min(1.0F, length_px / 2.0F + 0.5F - std::abs(static_cast<float>(k)));
      if (weight <= 0.0F) continue;
      sum += line[static_cast<std::size_t>(std::clamp(i + k, 0, count - 1))] * splat(weight);
      weights += weight;
    }
    first[i * step] = sum * splat(1.0F / weights);
  }
}

}  // namespace

Sensor::Sensor(const CameraSettings& settings, Eye eye, std::uint64_t seed)
    : settings_(settings),
      width_(settings.width_px),
      height_(settings.height_px()),
      seed_(seed * 2 + (eye == Eye::left ? 0 : 1)),
      tone_(tone_curve()) {
  const std::uint32_t pixels = key_of(seed_, 0xA11CE);
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
    }
  }
  raw_.assign(static_cast<std::size_t>((width_ + 2 * kMargin) * (height_ + 2 * kMargin)), 0.0F);
}

cv::Mat3b Sensor::expose(std::vector<V4> light, const Exposure& exposure, const Smear& smear,
                         std::uint64_t frame) {
  blur_by_lens(light);
  if (smear.u_px > 0.3F) smear_rows(light, smear.u_px + 1.0F);
  if (smear.v_px > 0.3F) smear_columns(light, smear.v_px + 1.0F);
  read_out(light, exposure, frame);
  return demosaic();
}

/// A lens is not sharper than the pixels: a cross-shaped point spread, which also keeps colours
/// from fringing in the mosaic.
void Sensor::blur_by_lens(std::vector<V4>& light) {
  constexpr float kSpread = 0.09F;
  lens_ = light;
  for (int y = 1; y + 1 < height_; ++y) {
    const V4* in = lens_.data() + y * width_;
    V4* out = light.data() + y * width_;
    for (int x = 1; x + 1 < width_; ++x) {
      const V4 around = in[x - 1] + in[x + 1] + in[x - width_] + in[x + width_];
      out[x] = in[x] * splat(1.0F - 4.0F * kSpread) + around * splat(kSpread);
    }
  }
}

void Sensor::smear_rows(std::vector<V4>& light, float length_px) const {
  std::vector<V4> line;
  for (int y = 0; y < height_; ++y) average(light.data() + y * width_, 1, width_, length_px, line);
}

void Sensor::smear_columns(std::vector<V4>& light, float length_px) const {
  std::vector<V4> line;
  for (int x = 0; x < width_; ++x) average(light.data() + x, width_, height_, length_px, line);
}

void Sensor::read_out(const std::vector<V4>& light, const Exposure& exposure, std::uint64_t frame) {
  const auto full = static_cast<float>(settings_.full_well_e);
  const auto electrons =
      static_cast<float>(ExposureControl(settings_).sensitivity() * exposure.shutter_s) * full;
  const auto read_variance = static_cast<float>(settings_.read_noise_e * settings_.read_noise_e);
  const float noise = settings_.noise ? 1.0F : 0.0F;
  const std::uint32_t key = key_of(seed_, frame);
  const int stride = width_ + 2 * kMargin;
  for (int y = 0; y < height_; ++y) {
    float* out = raw_.data() + (y + kMargin) * stride + kMargin;
    const V4* in = light.data() + y * width_;
    const float* sensitivity = sensitivity_.data() + y * width_;
    const std::uint32_t row = mix(key, static_cast<std::uint32_t>(y));
    for (int x = 0; x < width_; ++x) {
      const int c = colour_at(x, y);
      const float filter = kFilter[static_cast<std::size_t>(c)];
      // A full well holds no more, however bright the light.
      const float mean = std::min(full, in[x][c] * electrons * sensitivity[x] * filter);
      const float sigma = std::sqrt(mean + read_variance);
      const float counted =
          mean + noise * sigma * gauss_(mix(row + static_cast<std::uint32_t>(x) * 0x9E3779B9U));
      out[x] = std::min(1.0F, counted * static_cast<float>(exposure.gain) / (full * filter));
    }
    // Mirrored margins keep the mosaic's colours in step.
    out[-1] = out[1];
    out[-2] = out[2];
    out[width_] = out[width_ - 2];
    out[width_ + 1] = out[width_ - 3];
  }
  for (int k = 1; k <= kMargin; ++k) {
    const auto row = [&](int y) { return raw_.begin() + (y + kMargin) * stride; };
    std::copy_n(row(k), stride, row(-k));
    std::copy_n(row(height_ - 1 - k), stride, row(height_ - 1 + k));
  }
}

/// Malvar, He and Cutler 2004, "High-quality linear interpolation for demosaicing of
/// Bayer-patterned color images": bilinear plus the gradient of the colour that is known. Held
/// between the neighbours of its own colour, as cameras do: else every lamp has a fringe.
cv::Mat3b Sensor::demosaic() const {
  cv::Mat3b picture(height_, width_);
  const int s = width_ + 2 * kMargin;
  const auto held = [](float value, float a, float b) {
    return std::min(std::max(value, std::min(a, b)), std::max(a, b));
  };
  for (int y = 0; y < height_; ++y) {
    const float* p = raw_.data() + (y + kMargin) * s + kMargin;
    std::uint8_t* out = picture.ptr(y);
    for (int x = 0; x < width_; ++x, ++p, out += 3) {
      const float here = p[0];
      const float diagonal = p[-s - 1] + p[-s + 1] + p[s - 1] + p[s + 1];
      const float wide = p[-2] + p[2];
      const float tall = p[-2 * s] + p[2 * s];
      const int c = colour_at(x, y);
      if (c == 1) {
        const float beside =
            (5.0F * here + 4.0F * (p[-1] + p[1]) - diagonal - wide + 0.5F * tall) * 0.125F;
        const float above =
            (5.0F * here + 4.0F * (p[-s] + p[s]) - diagonal - tall + 0.5F * wide) * 0.125F;
        const bool red_row = y % 2 == 0;
        out[red_row ? 2 : 0] = tone(held(beside, p[-1], p[1]));
        out[1] = tone(here);
        out[red_row ? 0 : 2] = tone(held(above, p[-s], p[s]));
      } else {
        const float cross = p[-1] + p[1] + p[-s] + p[s];
        const float green = (4.0F * here + 2.0F * cross - wide - tall) * 0.125F;
        const float other = (6.0F * here + 2.0F * diagonal - 1.5F * (wide + tall)) * 0.125F;
        out[c] = tone(here);
        out[1] = tone(held(green, std::min(std::min(p[-1], p[1]), std::min(p[-s], p[s])),
                           std::max(std::max(p[-1], p[1]), std::max(p[-s], p[s]))));
        out[2 - c] =
            tone(held(other, std::min(std::min(p[-s - 1], p[s + 1]), std::min(p[-s + 1], p[s - 1])),
                      std::max(std::max(p[-s - 1], p[s + 1]), std::max(p[-s + 1], p[s - 1]))));
      }
    }
  }
  return picture;
}

}  // namespace striate::simulator::render
