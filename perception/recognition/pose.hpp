#pragma once

#include <span>

#include "striate/perception/percept.hpp"

namespace striate::perception {

/// Where a keypoint is, how large, and which way it is turned.
struct KeypointFrame {
  double u_px = 0.0;
  double v_px = 0.0;
  double size_px = 1.0;
  double angle_rad = 0.0;  ///< from +u towards +v
};

[[nodiscard]] inline KeypointFrame place_of(const Keypoint& point) {
  return {point.u_px, point.v_px, point.wavelength_px, point.angle_rad};
}

/// A keypoint of a view and one of the image that may show the same.
struct PlacePair {
  KeypointFrame view;
  KeypointFrame image;
  int view_point = 0;  ///< index in the view
};

/// An affine map from view to image: u' = a u + b v + c, v' = d u + e v + f.
struct Pose {
  double a = 1.0, b = 0.0, c = 0.0;
  double d = 0.0, e = 1.0, f = 0.0;

  [[nodiscard]] double u_of(double u, double v) const { return a * u + b * v + c; }
  [[nodiscard]] double v_of(double u, double v) const { return d * u + e * v + f; }
  [[nodiscard]] double determinant() const { return a * e - b * d; }
  /// Image pixels a pixel of the view; 0 for a mirrored pose.
  [[nodiscard]] double scale() const;
  /// How far it turns, from +u towards +v.
  [[nodiscard]] double angle_rad() const;
  /// Larger over smaller singular value: 1 for a similarity; infinite for a mirrored pose.
  [[nodiscard]] double stretch() const;
};

/// The similarity that one pair of keypoints says by itself.
[[nodiscard]] Pose pose_of_pair(const PlacePair& pair);

/// Least squares over all pairs (at least 2, else the identity): turn, scale and shift.
[[nodiscard]] Pose fit_similarity(std::span<const PlacePair> pairs);

/// Least squares over all pairs, six parameters; where they lie on a line the similarity.
[[nodiscard]] Pose fit_affine(std::span<const PlacePair> pairs);

}  // namespace striate::perception
