#include "perception/keypoints/keypoints.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "config/user_error.hpp"
#include "perception/descriptor/dense_descriptor.hpp"

namespace striate {
namespace {

double wavelength_of(const KeypointSettings& s) {
  const double wavelength = s.wavelength_px / (s.halve ? 2.0 : 1.0);
  if (!(wavelength >= 3.0 && wavelength <= 12.0)) {
    throw UserError(
        "keypoints: the wavelength on the picture that is worked on must be 3 .. 12 px");
  }
  if (s.most < 1) throw UserError("keypoints: 'most' must be at least 1");
  return wavelength;
}

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

bool strictly_highest(const Plane<float>& plane, int y, int x) {
  const float here = plane.row(y)[x];
  for (int v = -1; v <= 1; ++v) {
    for (int u = -1; u <= 1; ++u) {
      if ((u != 0 || v != 0) && plane.row(y + v)[x + u] >= here) return false;
    }
  }
  return true;
}

}  // namespace

KeypointFinder::KeypointFinder(const KeypointSettings& settings)
    : settings_(settings),
      scale_(settings.halve ? 2.0 : 1.0),
      wavelength_px_(wavelength_of(settings)),
      geometry_(end_stopped_geometry(wavelength_px_, settings.inhibition, settings.radial_factor)),
      cells_(v1_settings(wavelength_px_)) {}

/// Strict maxima in 3x3, in pixels of the picture that is worked on.
void KeypointFinder::collect(std::vector<Keypoint>& found) const {
  const int border = static_cast<int>(std::ceil(wavelength_px_));
  float largest = 0.0F;
  for (int y = 0; y < response_.height(); ++y) {
    largest = std::max(largest,
                       *std::max_element(response_.row(y), response_.row(y) + response_.width()));
  }
  const float least = largest * static_cast<float>(settings_.threshold);
  for (int y = border; y < response_.height() - border; ++y) {
    const float* row = response_.row(y);
    for (int x = border; x < response_.width() - border; ++x) {
      if (row[x] <= least || !strictly_highest(response_, y, x)) continue;
      Keypoint point;
      point.u_px = x + peak(row[x - 1], row[x], row[x + 1]);
      point.v_px = y + peak(response_.row(y - 1)[x], row[x], response_.row(y + 1)[x]);
      point.response = row[x];
      found.push_back(point);
    }
  }
}

void KeypointFinder::describe(std::vector<Keypoint>& found) const {
  const auto points = descriptor_points(wavelength_px_, 1.0);
  for (Keypoint& point : found) {
    point.descriptor = describe_pixel(responses_, points, static_cast<int>(std::lround(point.u_px)),
                                      static_cast<int>(std::lround(point.v_px)));
    // A pixel of the halved picture is the mean of 2x2: its centre lies between them.
    point.u_px = (point.u_px + 0.5) * scale_ - 0.5;
    point.v_px = (point.v_px + 0.5) * scale_ - 0.5;
    point.wavelength_px = settings_.wavelength_px;
    point.response /= responses_.gain;
  }
}

std::vector<Keypoint> KeypointFinder::find(const cv::Mat1b& grey) {
  if (grey.empty()) throw std::invalid_argument("KeypointFinder: the picture is empty");
  cv::Mat1b picture = grey;
  if (settings_.halve) {
    // An odd last row or column is left out: pixels must stay where they are.
    const cv::Size half(std::max(1, grey.cols / 2), std::max(1, grey.rows / 2));
    const cv::Rect even(0, 0, std::min(grey.cols, 2 * half.width),
                        std::min(grey.rows, 2 * half.height));
    cv::resize(grey(even), picture, half, 0, 0, cv::INTER_AREA);
  }
  const int reach = std::max(geometry_.reach, descriptor_reach(wavelength_px_, 1.0));
  cells_.respond(picture, reach, false, responses_);
  complex_planes(responses_, complex_);
  end_stopped_response(complex_, geometry_, response_);
  std::vector<Keypoint> found;
  collect(found);
  std::ranges::stable_sort(found, std::ranges::greater{}, &Keypoint::response);
  if (found.size() > static_cast<std::size_t>(settings_.most)) {
    found.resize(static_cast<std::size_t>(settings_.most));
  }
  describe(found);
  return found;
}

std::vector<Keypoint> find_keypoints(const cv::Mat1b& grey, const KeypointSettings& settings) {
  return KeypointFinder(settings).find(grey);
}

}  // namespace striate
