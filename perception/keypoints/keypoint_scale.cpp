#include "striate/perception/keypoints/keypoint_scale.hpp"

#include <algorithm>
#include <cmath>

#include "striate/perception/descriptor/dense_descriptor.hpp"

namespace striate::perception {
namespace {

V1Settings v1_settings(double wavelength_px) {
  V1Settings v1;
  v1.wavelength_px = wavelength_px;
  return v1;
}

/// Distance of a parabola's peak from its middle one of three points, -0.5..0.5.
double peak(double before, double at, double after) {
  const double curvature = before - 2.0 * at + after;
  return curvature < 0.0 ? std::clamp(0.5 * (before - after) / curvature, -0.5, 0.5) : 0.0;
}

}  // namespace

KeypointScale::KeypointScale(int index, double wavelength_px, const KeypointSettings& settings)
    : index_(index),
      wavelength_px_(wavelength_px),
      settings_(settings),
      v1_cells_(v1_settings(wavelength_px)),
      end_stopped_cells_(wavelength_px, settings),
      points_(descriptor_points(wavelength_px, 1.0)) {}

void KeypointScale::find(const cv::Mat1b& image, std::vector<Candidate>& out) {
  const int reach = std::max(end_stopped_cells_.reach(), descriptor_reach(wavelength_px_, 1.0));
  v1_cells_.respond(image, reach, false, responses_);
  end_stopped_cells_.respond(responses_, response_);
  const double least = settings_.threshold * largest_value(response_);
  find_strict_maxima(response_, static_cast<int>(std::ceil(wavelength_px_)),
                     static_cast<std::uint16_t>(least), maxima_);
  const auto most = static_cast<std::size_t>(settings_.most);
  if (maxima_.size() > most) {
    auto stronger = [](const GridPoint& a, const GridPoint& b) {
      return a.value != b.value ? a.value > b.value : a.y != b.y ? a.y < b.y : a.x < b.x;
    };
    std::nth_element(maxima_.begin(), maxima_.begin() + settings_.most, maxima_.end(), stronger);
    maxima_.resize(most);
  }
  // The kernels' sums grow with the square of the wavelength; K is kept in half units.
  const double unit = 2.0 / (responses_.gain * wavelength_px_ * wavelength_px_ *
                             std::pow(2.0, 0.5 * index_ * settings_.fine_first));
  for (const GridPoint& p : maxima_) {
    const std::uint16_t* row = response_.row(p.y) + p.x;
    out.push_back({p.x + peak(row[-1], row[0], row[1]),
                   p.y + peak(response_.row(p.y - 1)[p.x], row[0], response_.row(p.y + 1)[p.x]),
                   unit * p.value, index_});
  }
}

Descriptor KeypointScale::describe(const Candidate& candidate) const {
  return describe_pixel(responses_, points_, static_cast<int>(std::lround(candidate.u_px)),
                        static_cast<int>(std::lround(candidate.v_px)));
}

}  // namespace striate::perception
