#include "striate/perception/keypoints/end_stopped.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace striate::perception {
namespace {

/// @param share all weights are multiplied by it, 0..1.
Sample sample_at(double u, double v, double share = 1.0) {
  // Without the nudge, 2.4 * sin(pi) would ask for the pixel at -1e-16.
  const double left = std::floor(u + 1e-9), top = std::floor(v + 1e-9);
  const double right = std::max(0.0, u - left), bottom = std::max(0.0, v - top);
  // Rounded to 1/4096 first: not at the mercy of the mathematics library's last bit.
  auto weight = [share](double w) {
    return static_cast<std::uint16_t>(std::lround(share * std::round(w * 4096.0) * 8.0));
  };
  return {static_cast<int>(left),
          static_cast<int>(top),
          {weight((1 - right) * (1 - bottom)), weight(right * (1 - bottom)),
           weight((1 - right) * bottom), weight(right * bottom)}};
}

}  // namespace

FixedFactor fixed_factor(double factor) {
  FixedFactor fixed;
  while (factor >= 1.0) {
    factor /= 2.0;
    ++fixed.doublings;
  }
  fixed.fraction = static_cast<std::uint16_t>(std::min(65535L, std::lround(factor * 65536.0)));
  return fixed;
}

EndStoppedGeometry end_stopped_geometry(double wavelength_px, const KeypointSettings& settings) {
  EndStoppedGeometry geometry;
  geometry.inhibition = fixed_factor(settings.inhibition);
  geometry.radial_factor = fixed_factor(settings.radial_factor);
  geometry.single_stopped = settings.response == EndStoppedResponse::largest;
  const double share = geometry.radial_factor.fraction / 65536.0;
  constexpr double kDistance = 0.6;  // of lambda; the V1 model's d
  const double d = kDistance * wavelength_px;
  for (std::size_t i = 0; i < kOrientations; ++i) {
    const double theta = static_cast<double>(i) * std::numbers::pi / kOrientations;
    const double c = std::cos(theta), s = std::sin(theta);
    EndStoppedGeometry::Places& p = geometry.places[i];
    p.single = {sample_at(d * s, -d * c), sample_at(-d * s, d * c)};
    p.double_ = {sample_at(2 * d * s, -2 * d * c), sample_at(-2 * d * s, 2 * d * c)};
    p.tangential = {sample_at(d * c, d * s), sample_at(-d * c, -d * s)};
    p.radial = {sample_at(d / 2 * c, d / 2 * s, share), sample_at(-d / 2 * c, -d / 2 * s, share)};
  }
  geometry.reach = static_cast<int>(std::ceil(2 * d)) + 1;
  return geometry;
}

EndStoppedCells::EndStoppedCells(double wavelength_px, const KeypointSettings& settings)
    : geometry_(end_stopped_geometry(wavelength_px, settings)) {
  job_.radial_doublings = geometry_.radial_factor.doublings;
  job_.inhibition = geometry_.inhibition.fraction;
  job_.inhibition_doublings = geometry_.inhibition.doublings;
  job_.single_stopped = geometry_.single_stopped;
}

const std::uint16_t* EndStoppedCells::ring_row(std::size_t orientation, int y) const {
  const int rows = rings_[0].height();
  return rings_[orientation].row((y + rows) % rows);
}

/// Row y of all C_i, from `reach` before the first column to `reach` behind the last.
void EndStoppedCells::take_row(const V1Responses& responses, int y) {
  const int reach = geometry_.reach, rows = rings_[0].height();
  for (std::size_t i = 0; i < kOrientations; ++i) {
    end_stopped_kernels::amplitudes(responses.code[i].row(y) - reach, responses.width + 2 * reach,
                                    rings_[i].row((y + rows) % rows) - reach);
  }
}

end_stopped_kernels::Tap EndStoppedCells::tap(std::size_t orientation, const Sample& sample,
                                              int y) const {
  end_stopped_kernels::Tap result;
  result.upper = ring_row(orientation, y + sample.dv) + sample.du;
  result.lower = ring_row(orientation, y + sample.dv + 1) + sample.du;
  for (std::size_t k = 0; k < 4; ++k) result.weights[k] = sample.weights[k] * 0x10001U;
  return result;
}

void EndStoppedCells::look_from_row(int y) {
  for (std::size_t i = 0; i < kOrientations; ++i) {
    const EndStoppedGeometry::Places& places = geometry_.places[i];
    end_stopped_kernels::OrientationTaps& taps = job_.taps[i];
    taps.centre = ring_row(i, y);
    for (std::size_t side = 0; side < 2; ++side) {
      taps.double_[side] = tap(i, places.double_[side], y);
      taps.tangential[side] = tap(i, places.tangential[side], y);
      taps.radial[side] = tap((i + kOrientations / 2) % kOrientations, places.radial[side], y);
      taps.single[side] = tap(i, places.single[side], y);
    }
  }
}

void EndStoppedCells::respond(const V1Responses& responses, Plane<std::uint16_t>& out) {
  const int reach = geometry_.reach;
  // One column and vector more than the responses' own margin, for what is written ahead.
  for (auto& ring : rings_) ring.resize(responses.width, 2 * reach + 1, reach + 64, 0);
  out.resize(responses.width, responses.height, 0, 0);
  for (int y = -reach; y < reach; ++y) take_row(responses, y);
  for (int y = 0; y < responses.height; ++y) {
    take_row(responses, y + reach);
    look_from_row(y);
    end_stopped_kernels::respond_row(job_, responses.width, out.row(y));
  }
}

}  // namespace striate::perception
