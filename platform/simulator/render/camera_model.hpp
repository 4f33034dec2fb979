#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "striate/platform/simulator/render/camera_settings.hpp"
#include "striate/platform/simulator/render/demosaic.hpp"
#include "striate/platform/simulator/render/noise.hpp"
#include "striate/platform/simulator/render/vec.hpp"
#include "striate/platform/simulator/render/view.hpp"

namespace striate::simulator::render {

struct Exposure {
  double shutter_s = 0.0;
  double gain = 1.0;
};

/// Exposure control as cameras have it: seeks a mean level, first by the shutter, then by the
/// gain, part of the way each image.
class ExposureControl {
 public:
  explicit ExposureControl(const CameraSettings& settings) : settings_(settings) {}
  /// The exposure of the next image. The first one is exposed rightly at once, as a camera that
  /// has been running for a while.
  [[nodiscard]] Exposure choose(const std::vector<V4>& light);
  /// Grey level (of full scale) per unit of light and second of shutter at gain 1.
  [[nodiscard]] double sensitivity() const;

 private:
  [[nodiscard]] double mean_level(const std::vector<V4>& light, double product) const;
  const CameraSettings& settings_;
  double product_s_ = 0.0;  ///< shutter times gain; 0 before the first image
};

/// How far the image moves during the exposure, by turning, in pixels.
struct Smear {
  float u_px = 0.0F;
  float v_px = 0.0F;
};

/// One sensor: light in, 8-bit image out. Vignetting, smear, unevenness of the pixels, shot and
/// read noise, Bayer mosaic and its interpolation (Malvar, He and Cutler 2004), tone curve.
class Sensor {
 public:
  /// @param common_pattern spread of the pixels' sensitivity that is the same in both eyes
  Sensor(const CameraSettings& settings, Eye eye, std::uint64_t seed, double common_pattern = 0.0);

  cv::Mat3b expose(const std::vector<V4>& light, const Exposure& exposure, const Smear& smear,
                   std::uint64_t frame);

 private:
  void blur_by_lens(const std::vector<V4>& light);
  void smear_rows(float length_px);
  void smear_columns(float length_px);
  void read_out(const Exposure& exposure, std::uint64_t frame);

  const CameraSettings& settings_;
  int width_ = 0;
  int height_ = 0;
  std::uint64_t seed_ = 0;
  GaussTable gauss_;
  std::vector<V4> lens_;            ///< the light behind the lens, then smeared
  std::vector<float> sensitivity_;  ///< per pixel: vignetting, unevenness, this eye's gain
  std::vector<float> raw_;          ///< grey levels of full scale, two pixels of margin all round
  Demosaic demosaic_;
};

}  // namespace striate::simulator::render
