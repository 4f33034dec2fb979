#include "striate/platform/simulator/render/demosaic.hpp"

#include <cmath>
#include <cstring>

#include "striate/platform/simulator/render/vec.hpp"

namespace striate::simulator::render {
namespace {

constexpr int kTones =
    4096;  // 12 bits of light before the tone curve makes 8 of them, as a sensor's converter gives
constexpr int kLanes = Demosaic::kSlack;  // pixels at a time

std::vector<std::uint8_t> tone_curve() {
  std::vector<std::uint8_t> curve(kTones);
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const double x = static_cast<double>(i) / (kTones - 1);
    const double y = x < 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1.0 / 2.4) - 0.055;
    curve[i] = static_cast<std::uint8_t>(std::lround(255.0 * y));
  }
  return curve;
}

V4 least(V4 a, V4 b) {
  return a < b ? a : b;
}
V4 most(V4 a, V4 b) {
  return a > b ? a : b;
}

V4 load(const float* from) {
  V4 value;
  std::memcpy(&value, from, sizeof value);
  return value;
}

/// Four places in the tone curve.
void keep(V4 level, int* to) {
  const V4 place =
      least(most(level, splat(0.0F)), splat(1.0F)) * splat(kTones - 1.0F) + splat(0.5F);
  const I4 whole = __builtin_convertvector(place, I4);
  std::memcpy(to, &whole, sizeof whole);
}

V4 held(V4 value, V4 low, V4 high) {
  return least(most(value, low), high);
}

}  // namespace

Demosaic::Demosaic(int width, int height) : width_(width), height_(height), tone_(tone_curve()) {
  for (std::vector<int>* line : {&row_.here, &row_.beside, &row_.above, &row_.green, &row_.other}) {
    line->resize(static_cast<std::size_t>(width) + kLanes);
  }
}

void Demosaic::interpolate(const float* cell) {
  const int s = width_ + 2 * kMargin;
  for (int x = 0; x < width_; x += kLanes) {
    const float* p = cell + x;
    const V4 here = load(p);
    const V4 left = load(p - 1), right = load(p + 1), up = load(p - s), down = load(p + s);
    const V4 up_left = load(p - s - 1), up_right = load(p - s + 1);
    const V4 down_left = load(p + s - 1), down_right = load(p + s + 1);
    const V4 diagonal = up_left + up_right + down_left + down_right;
    const V4 wide = load(p - 2) + load(p + 2);
    const V4 tall = load(p - 2 * s) + load(p + 2 * s);
    const V4 beside =
        (5.0F * here + 4.0F * (left + right) - diagonal - wide + 0.5F * tall) * 0.125F;
    const V4 above = (5.0F * here + 4.0F * (up + down) - diagonal - tall + 0.5F * wide) * 0.125F;
    const V4 green = (4.0F * here + 2.0F * (left + right + up + down) - wide - tall) * 0.125F;
    const V4 other = (6.0F * here + 2.0F * diagonal - 1.5F * (wide + tall)) * 0.125F;
    keep(here, row_.here.data() + x);
    keep(held(beside, least(left, right), most(left, right)), row_.beside.data() + x);
    keep(held(above, least(up, down), most(up, down)), row_.above.data() + x);
    keep(held(green, least(least(left, right), least(up, down)),
              most(most(left, right), most(up, down))),
         row_.green.data() + x);
    keep(held(other, least(least(up_left, down_right), least(down_left, up_right)),
              most(most(up_left, down_right), most(down_left, up_right))),
         row_.other.data() + x);
  }
}

cv::Mat3b Demosaic::image(const std::vector<float>& raw) {
  cv::Mat3b image(height_, width_);
  const int stride = width_ + 2 * kMargin;
  const auto tone = [&](const std::vector<int>& line, int x) {
    return tone_[static_cast<std::size_t>(line[static_cast<std::size_t>(x)])];
  };
  for (int y = 0; y < height_; ++y) {
    interpolate(raw.data() + (y + kMargin) * stride + kMargin);
    std::uint8_t* out = image.ptr(y);
    const int known = y % 2 == 0 ? 2 : 0;  // red or blue stands in this row, beside green
    for (int x = 0; x < width_; ++x, out += 3) {
      if ((x + y) % 2 != 0) {
        out[known] = tone(row_.beside, x);
        out[1] = tone(row_.here, x);
        out[2 - known] = tone(row_.above, x);
      } else {
        out[known] = tone(row_.here, x);
        out[1] = tone(row_.green, x);
        out[2 - known] = tone(row_.other, x);
      }
    }
  }
  return image;
}

}  // namespace striate::simulator::render
