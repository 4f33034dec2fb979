#include "striate/perception/recognition/pose.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace striate::perception {
namespace {

/// Means and centred second moments of pairs.
struct Moments {
  double u = 0.0, v = 0.0, u_image = 0.0, v_image = 0.0;
  double uu = 0.0, uv = 0.0, vv = 0.0;
  double u_up = 0.0, u_vp = 0.0, v_up = 0.0, v_vp = 0.0;  ///< view's u or v, image's u or v

  explicit Moments(std::span<const PlacePair> pairs) {
    const double count = static_cast<double>(pairs.size());
    for (const PlacePair& pair : pairs) {
      u += pair.view.u_px / count;
      v += pair.view.v_px / count;
      u_image += pair.image.u_px / count;
      v_image += pair.image.v_px / count;
    }
    for (const PlacePair& pair : pairs) {
      const double x = pair.view.u_px - u, y = pair.view.v_px - v;
      const double xp = pair.image.u_px - u_image, yp = pair.image.v_px - v_image;
      uu += x * x, uv += x * y, vv += y * y;
      u_up += x * xp, u_vp += x * yp, v_up += y * xp, v_vp += y * yp;
    }
  }
  /// Shifts the pose so that mean falls on mean.
  [[nodiscard]] Pose centred(Pose pose) const {
    pose.c = u_image - pose.a * u - pose.b * v;
    pose.f = v_image - pose.d * u - pose.e * v;
    return pose;
  }
};

Pose similarity(const Moments& m) {
  const double spread = m.uu + m.vv;
  if (!(spread > 0.0)) return m.centred({});
  const double along = (m.u_up + m.v_vp) / spread, across = (m.u_vp - m.v_up) / spread;
  return m.centred({along, -across, 0.0, across, along, 0.0});
}

}  // namespace

double Pose::scale() const {
  return std::sqrt(std::max(0.0, determinant()));
}

double Pose::angle_rad() const {
  return std::atan2(d - b, a + e);
}

double Pose::stretch() const {
  if (!(determinant() > 0.0)) return std::numeric_limits<double>::infinity();
  const double sum = std::hypot(a + e, d - b), difference = std::hypot(a - e, d + b);
  return (sum + difference) / (sum - difference);
}

Pose pose_of_pair(const PlacePair& pair) {
  const double scale = pair.image.size_px / pair.view.size_px;
  const double turn = pair.image.angle_rad - pair.view.angle_rad;
  const double c = scale * std::cos(turn), s = scale * std::sin(turn);
  return {c, -s, pair.image.u_px - c * pair.view.u_px + s * pair.view.v_px,
          s, c,  pair.image.v_px - s * pair.view.u_px - c * pair.view.v_px};
}

Pose fit_similarity(std::span<const PlacePair> pairs) {
  if (pairs.size() < 2) return {};
  return similarity(Moments(pairs));
}

Pose fit_affine(std::span<const PlacePair> pairs) {
  if (pairs.size() < 2) return {};
  const Moments m(pairs);
  const double determinant = m.uu * m.vv - m.uv * m.uv;
  const double spread = m.uu + m.vv;
  // Points in a narrow strip say nothing about what is across it: ten times as long as wide (ours).
  constexpr double kNarrow = 0.01;  // of the squared spread: (1 / 10)^2
  if (!(determinant > kNarrow * spread * spread)) return similarity(m);
  Pose pose;
  pose.a = (m.u_up * m.vv - m.v_up * m.uv) / determinant;
  pose.b = (m.v_up * m.uu - m.u_up * m.uv) / determinant;
  pose.d = (m.u_vp * m.vv - m.v_vp * m.uv) / determinant;
  pose.e = (m.v_vp * m.uu - m.u_vp * m.uv) / determinant;
  return m.centred(pose);
}

}  // namespace striate::perception
