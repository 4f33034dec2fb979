#include "striate/perception/visual_odometry/bundle.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>

namespace striate::perception {
namespace {

using BundleMatrix36 = Eigen::Matrix<double, 3, 6>;
using BundleMatrix63 = Eigen::Matrix<double, 6, 3>;
using RowMatrix36 = Eigen::Matrix<double, 3, 6, Eigen::RowMajor>;
using RowMatrix3 = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

constexpr double kBehindCost = 100.0;  // chi squared of a point behind a camera (by hand)

struct LinearSight {
  int camera = 0;
  BundleMatrix36 of_camera;
  Eigen::Matrix3d of_point;
  Eigen::Vector3d residual;
  double weight = 0.0;
};

bool linearise(const Bundle& bundle, const BundleSight& seen, LinearSight& linear) {
  const RigidMotion& pose = bundle.camera_from_world[static_cast<std::size_t>(seen.camera)];
  const cv::Vec3d p = pose * bundle.points_m[static_cast<std::size_t>(seen.point)];
  if (p[2] < kNearestSeen_m) return false;
  const cv::Matx<double, 3, 6> slope = pose_slope(bundle.eyes, p);
  const cv::Vec3d r = seen.sight - sight_of(bundle.eyes, p);
  linear.camera = seen.camera;
  linear.residual = Eigen::Vector3d(r[0], r[1], r[2]);
  linear.of_camera = Eigen::Map<const RowMatrix36>(slope.val);
  linear.of_point =
      linear.of_camera.leftCols<3>() * Eigen::Map<const RowMatrix3>(pose.rotation.val);
  const double noise = seen.noise_px * bundle.noise_px;
  const double weight = 1.0 / (noise * noise);
  linear.weight = weight / (1.0 + linear.residual.squaredNorm() * weight / kCauchyChi3);
  return true;
}

/// The equations of the cameras after the points are eliminated.
struct CameraEquations {
  explicit CameraEquations(int cameras)
      : matrix(Eigen::MatrixXd::Zero(6 * cameras, 6 * cameras)),
        pull(Eigen::VectorXd::Zero(6 * cameras)) {}
  Eigen::MatrixXd matrix;
  Eigen::VectorXd pull;
};

/// What is needed to find a point's step once the cameras' are known.
struct PointEquations {
  Eigen::Matrix3d inverse = Eigen::Matrix3d::Zero();
  Eigen::Vector3d pull = Eigen::Vector3d::Zero();
  std::vector<std::pair<int, BundleMatrix63>> with_cameras;
};

void eliminate(const std::vector<LinearSight>& sights, double damping, CameraEquations& cameras,
               PointEquations& point) {
  Eigen::Matrix3d own = Eigen::Matrix3d::Zero();
  for (const LinearSight& s : sights) {
    own += s.weight * s.of_point.transpose() * s.of_point;
    point.pull += s.weight * s.of_point.transpose() * s.residual;
    if (s.camera == 0) continue;
    const Eigen::Index at = 6 * (s.camera - 1);
    cameras.matrix.block<6, 6>(at, at) += s.weight * s.of_camera.transpose() * s.of_camera;
    cameras.pull.segment<6>(at) += s.weight * s.of_camera.transpose() * s.residual;
    point.with_cameras.emplace_back(s.camera, s.weight * s.of_camera.transpose() * s.of_point);
  }
  own.diagonal() *= 1.0 + damping;
  point.inverse = own.inverse();
  for (const auto& [i, to_i] : point.with_cameras) {
    const BundleMatrix63 part = to_i * point.inverse;
    cameras.pull.segment<6>(6 * (i - 1)) -= part * point.pull;
    for (const auto& [k, to_k] : point.with_cameras) {
      cameras.matrix.block<6, 6>(6 * (i - 1), 6 * (k - 1)) -= part * to_k.transpose();
    }
  }
}

cv::Vec6d camera_step(const Eigen::VectorXd& steps, int camera) {
  cv::Vec6d step;
  for (int k = 0; k < 6; ++k) step[k] = steps[6 * (camera - 1) + k];
  return step;
}

}  // namespace

double bundle_cost(const Bundle& bundle) {
  double cost = 0.0;
  for (const BundleSight& seen : bundle.sights) {
    const RigidMotion& pose = bundle.camera_from_world[static_cast<std::size_t>(seen.camera)];
    const cv::Vec3d p = pose * bundle.points_m[static_cast<std::size_t>(seen.point)];
    if (p[2] < kNearestSeen_m) {
      cost += kBehindCost;
      continue;
    }
    const cv::Vec3d r = seen.sight - sight_of(bundle.eyes, p);
    const double noise = seen.noise_px * bundle.noise_px;
    cost += kCauchyChi3 * std::log1p(r.dot(r) / (noise * noise * kCauchyChi3));
  }
  return cost;
}

bool bundle_step(const Bundle& bundle, double damping, Bundle& moved) {
  const int cameras = static_cast<int>(bundle.camera_from_world.size()) - 1;
  CameraEquations equations(cameras);
  std::vector<PointEquations> points(bundle.points_m.size());
  std::vector<LinearSight> of_one;
  for (std::size_t from = 0; from < bundle.sights.size();) {
    const int point = bundle.sights[from].point;
    of_one.clear();
    std::size_t to = from;
    for (; to < bundle.sights.size() && bundle.sights[to].point == point; ++to) {
      LinearSight linear;
      if (linearise(bundle, bundle.sights[to], linear)) of_one.push_back(linear);
    }
    from = to;
    if (of_one.size() > 1) {
      eliminate(of_one, damping, equations, points[static_cast<std::size_t>(point)]);
    }
  }
  equations.matrix.diagonal() *= 1.0 + damping;
  const Eigen::LDLT<Eigen::MatrixXd> ldlt(equations.matrix);
  if (ldlt.info() != Eigen::Success || !(ldlt.vectorD().minCoeff() > 0.0)) return false;
  const Eigen::VectorXd steps = ldlt.solve(equations.pull);
  if (!steps.allFinite()) return false;
  moved = bundle;
  for (int k = 1; k <= cameras; ++k) {
    RigidMotion& pose = moved.camera_from_world[static_cast<std::size_t>(k)];
    pose = straightened(nudged(pose, camera_step(steps, k)));
  }
  for (std::size_t k = 0; k < points.size(); ++k) {
    Eigen::Vector3d pull = points[k].pull;
    for (const auto& [camera, part] : points[k].with_cameras) {
      pull -= part.transpose() * steps.segment<6>(6 * (camera - 1));
    }
    const Eigen::Vector3d step = points[k].inverse * pull;
    if (!step.allFinite()) return false;
    moved.points_m[k] += cv::Vec3d(step[0], step[1], step[2]);
  }
  return true;
}

}  // namespace striate::perception
