#include "striate/evaluation/calibration/consistent_pairs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/calib3d.hpp>

namespace striate::evaluation {
namespace {

/// The board in front of one eye.
struct BoardPose {
  cv::Matx33d turn = cv::Matx33d::eye();
  cv::Vec3d way;
};

BoardPose pose_of(const std::vector<cv::Point2f>& seen_px, const Chessboard& board,
                  const pioneer::CameraModel& eye) {
  cv::Vec3d turn;
  BoardPose pose;
  cv::solvePnP(corners_of(board), seen_px, eye.matrix, eye.distortion, turn, pose.way);
  cv::Rodrigues(turn, pose.turn);
  return pose;
}

double error_of(const BoardPose& pose, const std::vector<cv::Point2f>& seen_px,
                const Chessboard& board, const pioneer::CameraModel& eye) {
  cv::Vec3d turn;
  cv::Rodrigues(pose.turn, turn);
  std::vector<cv::Point2f> expected_px;
  cv::projectPoints(corners_of(board), turn, pose.way, eye.matrix, eye.distortion, expected_px);
  double sum = 0.0;
  for (std::size_t k = 0; k < seen_px.size(); ++k) {
    const cv::Point2d apart = cv::Point2d(expected_px[k]) - cv::Point2d(seen_px[k]);
    sum += apart.dot(apart);
  }
  const double error = std::sqrt(sum / static_cast<double>(seen_px.size()));
  return std::isfinite(error) ? error : std::numeric_limits<double>::max();
}

BoardPose moved(const BoardPose& pose, const cv::Matx33d& turn, const cv::Vec3d& way) {
  return {turn * pose.turn, turn * pose.way + way};
}

/// Share of the image's width that one pair alone may be wrong about another: a board of a third of
/// the image whose corners err by 0.1 px tells the eyes' turn within 0.3 px, and its distance
/// within 0.1 %; by hand, ten times that.
constexpr double kAgrees = 0.006;
/// Times the error of a look: that of the pair that tells and of the one that is told of, each
/// spread by the way from eye to eye (by hand)
constexpr double kBlurs = 6.0;

}  // namespace

std::vector<std::size_t> consistent_pairs(const std::vector<BoardPair>& pairs,
                                          const Chessboard& board,
                                          const pioneer::StereoCalibration& lenses,
                                          double blur_px) {
  std::vector<BoardPose> left;
  std::vector<BoardPose> right;
  for (const BoardPair& pair : pairs) {
    left.push_back(pose_of(pair.left_px, board, lenses.left));
    right.push_back(pose_of(pair.right_px, board, lenses.right));
  }
  const double limit_px = std::max(kAgrees * lenses.size_px.width, kBlurs * blur_px);
  std::vector<std::size_t> best;
  double best_sum = 0.0;
  for (std::size_t by = 0; by < pairs.size(); ++by) {
    const cv::Matx33d turn = right[by].turn * left[by].turn.t();
    const cv::Vec3d way = right[by].way - turn * left[by].way;
    std::vector<std::size_t> agreeing;
    double sum = 0.0;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const double error =
          error_of(moved(left[i], turn, way), pairs[i].right_px, board, lenses.right);
      if (error > limit_px) continue;
      agreeing.push_back(i);
      sum += error;
    }
    const bool more = agreeing.size() > best.size();
    if (!more && (agreeing.size() < best.size() || sum >= best_sum)) continue;
    best = std::move(agreeing);
    best_sum = sum;
  }
  return best;
}

double disagreement_px(const BoardPair& pair, const Chessboard& board,
                       const pioneer::StereoCalibration& calibration) {
  const BoardPose left = pose_of(pair.left_px, board, calibration.left);
  return error_of(moved(left, calibration.rotation, calibration.translation_m), pair.right_px,
                  board, calibration.right);
}

}  // namespace striate::evaluation
