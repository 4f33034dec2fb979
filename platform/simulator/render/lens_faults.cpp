#include "striate/platform/simulator/render/lens_faults.hpp"

#include <algorithm>
#include <cmath>

namespace striate::simulator::render {
namespace {

/// Lamps on the mains of 50 Hz; a little off, as mains are, so that the bands wander slowly.
constexpr double kFlicker_Hz = 99.94;
/// Of the covered light that still comes through: a smear of grease, not a coin (by hand).
constexpr float kThroughDirt = 0.35F;
/// Of the image's mean light that dirt scatters into the pixels behind it (by hand).
constexpr float kVeil = 0.12F;
/// Radii of blots in shares of the image's width: far out of focus on the front lens (by hand).
constexpr double kLeastBlot = 0.03;
constexpr double kLargestBlot = 0.09;

V4 between_rows_and_columns(const std::vector<V4>& light, int width, int height, float u, float v) {
  const float x = std::clamp(u, 0.0F, static_cast<float>(width - 1));
  const float y = std::clamp(v, 0.0F, static_cast<float>(height - 1));
  const int x0 = std::min(static_cast<int>(x), width - 2);
  const int y0 = std::min(static_cast<int>(y), height - 2);
  const float fx = x - static_cast<float>(x0);
  const float fy = y - static_cast<float>(y0);
  const V4* cell = light.data() + y0 * width + x0;
  return (cell[0] * splat(1.0F - fx) + cell[1] * splat(fx)) * splat(1.0F - fy) +
         (cell[width] * splat(1.0F - fx) + cell[width + 1] * splat(fx)) * splat(fy);
}

}  // namespace

LensFaults::LensFaults(const EyeFaults& faults, const CameraSettings& settings, Eye eye,
                       std::uint64_t seed)
    : faults_(faults),
      width_(settings.width_px),
      height_(settings.height_px()),
      focal_px_(settings.width_px / 2.0 / std::tan(settings.field_rad / 2.0)),
      flicker_phase_(static_cast<double>(uniform(key_of(seed, 0xF1AC)))) {
  const Eye dirty = key_of(seed, 0xD187) % 2 == 0 ? Eye::left : Eye::right;
  if (faults.dirt > 0.0 && eye == dirty) lay_dirt(seed);
}

/// Blots, drawn until the share is covered.
void LensFaults::lay_dirt(std::uint64_t seed) {
  dirt_.assign(static_cast<std::size_t>(width_ * height_), 0.0F);
  constexpr std::uint64_t kMostBlots = 1000;  // never reached: a tenth of them cover everything
  double covered = 0.0;
  for (std::uint64_t blot = 0; blot < kMostBlots; ++blot) {
    if (covered >= faults_.dirt * static_cast<double>(dirt_.size())) break;
    const auto draw = [&](std::uint64_t k) {
      return static_cast<double>(uniform(key_of(seed, 0xD1270000 + 4 * blot + k)));
    };
    const double u = draw(0) * width_;
    const double v = draw(1) * height_;
    const double radius = (kLeastBlot + (kLargestBlot - kLeastBlot) * draw(2)) * width_;
    covered = 0.0;
    for (int y = 0; y < height_; ++y) {
      for (int x = 0; x < width_; ++x) {
        const double away = std::hypot(x - u, y - v) / radius;
        float& cell = dirt_[static_cast<std::size_t>(y * width_ + x)];
        cell = std::max(cell, static_cast<float>(std::clamp(1.5 - away, 0.0, 1.0)));
        covered += static_cast<double>(cell);
      }
    }
  }
}

double LensFaults::row_time_s(int y) const {
  return faults_.rolling_shutter_s * ((y + 0.5) / height_ - 0.5);
}

/// Where each pixel's light comes from: farther out by the lens, and where the scene stood in the
/// image when its row was taken.
void LensFaults::bend(const std::vector<V4>& light, const EyeMotion& motion) {
  const double centre_u = (width_ - 1) / 2.0;
  const double centre_v = (height_ - 1) / 2.0;
  const double corner2 = centre_u * centre_u + centre_v * centre_v;
  for (int y = 0; y < height_; ++y) {
    // The scene goes to the right when the eyes turn left, and down when they look up.
    const double right_px = focal_px_ * motion.turn_rad_s * row_time_s(y);
    const double down_px = focal_px_ * motion.nod_rad_s * row_time_s(y);
    for (int x = 0; x < width_; ++x) {
      const double du = x - centre_u;
      const double dv = y - centre_v;
      const double out = 1.0 + faults_.distortion * (du * du + dv * dv) / corner2;
      out_[static_cast<std::size_t>(y * width_ + x)] = between_rows_and_columns(
          light, width_, height_, static_cast<float>(centre_u + du * out - right_px),
          static_cast<float>(centre_v + dv * out - down_px));
    }
  }
}

/// White balance, and what the lamps give while a row is exposed: the mean of a cosine over it.
void LensFaults::weigh_rows(const EyeMotion& motion) {
  const auto white = static_cast<float>(faults_.white_balance);
  const V4 colours = bgr(1.0F - white, 1.0F, 1.0F + white);
  const double half = kPi * kFlicker_Hz * motion.shutter_s;
  const double evened = half > 1e-6 ? std::sin(half) / half : 1.0;
  for (int y = 0; y < height_; ++y) {
    const double turns = kFlicker_Hz * (motion.time_s + row_time_s(y)) + flicker_phase_;
    const double lamps = 1.0 + faults_.lamp_flicker * evened * std::cos(2.0 * kPi * turns);
    const V4 weight = colours * splat(static_cast<float>(lamps));
    V4* row = out_.data() + y * width_;
    for (int x = 0; x < width_; ++x) row[x] *= weight;
  }
}

void LensFaults::cover() {
  V4 mean{};
  for (const V4& pixel : out_) mean += pixel;
  mean *= splat(kVeil / static_cast<float>(out_.size()));
  for (std::size_t i = 0; i < out_.size(); ++i) {
    out_[i] = out_[i] * splat(1.0F - (1.0F - kThroughDirt) * dirt_[i]) + mean * splat(dirt_[i]);
  }
}

const std::vector<V4>& LensFaults::apply(const std::vector<V4>& light, const EyeMotion& motion) {
  const bool moved =
      faults_.rolling_shutter_s > 0.0 && (motion.turn_rad_s != 0.0 || motion.nod_rad_s != 0.0);
  const bool bent = faults_.distortion != 0.0 || moved;
  const bool weighed = faults_.white_balance != 0.0 || faults_.lamp_flicker > 0.0;
  if (!bent && !weighed && dirt_.empty()) return light;
  out_.resize(light.size());
  if (bent) {
    bend(light, motion);
  } else {
    out_ = light;
  }
  if (weighed) weigh_rows(motion);
  if (!dirt_.empty()) cover();
  return out_;
}

}  // namespace striate::simulator::render
