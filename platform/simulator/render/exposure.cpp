#include "striate/platform/simulator/render/camera_model.hpp"

namespace striate::simulator::render {
namespace {

/// Electrons per second and unit of light: an office wall then takes about 10 ms.
constexpr double kElectronsPerSecond = 6.0e5;

}  // namespace

double ExposureControl::sensitivity() const {
  return kElectronsPerSecond / settings_.full_well_e;
}

double ExposureControl::mean_level(const std::vector<V4>& light, double product_s) const {
  const auto k = static_cast<float>(product_s * sensitivity());
  double sum = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < light.size(); i += 37) {  // a prime: no column is favoured
    sum += static_cast<double>(std::min(1.0F, k * luminance(light[i])));
    ++count;
  }
  return sum / std::max(1, count);
}

Exposure ExposureControl::choose(const std::vector<V4>& light) {
  const double longest = settings_.max_shutter_s * settings_.max_gain;
  const bool first = product_s_ <= 0.0;
  if (first) product_s_ = 0.01;
  double right = product_s_;
  for (int i = 0; i < 12; ++i) {
    const double level = std::max(1e-5, mean_level(light, right));
    right =
        std::clamp(right * std::clamp(settings_.target_level / level, 0.1, 10.0), 2e-5, longest);
  }
  product_s_ *= std::pow(right / product_s_, first ? 1.0 : settings_.adaptation);
  Exposure exposure;
  exposure.shutter_s = std::min(product_s_, settings_.max_shutter_s);
  exposure.gain = product_s_ / exposure.shutter_s;
  return exposure;
}

}  // namespace striate::simulator::render
