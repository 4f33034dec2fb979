#include "striate/evaluation/calibration/chessboard.hpp"

#include <algorithm>
#include <opencv2/calib3d.hpp>

namespace striate::evaluation {
namespace {

bool find(const cv::Mat1b& image, const Chessboard& board, std::vector<cv::Point2f>& corners) {
  const cv::Size size(board.columns, board.rows);
  return cv::findChessboardCornersSB(image, size, corners,
                                     cv::CALIB_CB_EXHAUSTIVE | cv::CALIB_CB_ACCURACY);
}

}  // namespace

std::vector<cv::Point3f> corners_of(const Chessboard& board) {
  std::vector<cv::Point3f> corners;
  for (int row = 0; row < board.rows; ++row) {
    for (int column = 0; column < board.columns; ++column) {
      corners.emplace_back(static_cast<float>(column * board.square_m),
                           static_cast<float>(row * board.square_m), 0.0F);
    }
  }
  return corners;
}

std::optional<BoardPair> find_board(const cv::Mat1b& left, const cv::Mat1b& right,
                                    const Chessboard& board) {
  BoardPair pair;
  if (!find(left, board, pair.left_px) || !find(right, board, pair.right_px)) return std::nullopt;
  // A board that looks the same upside down may be counted from either end: the cameras stand side
  // by side, so both must count the same way.
  const cv::Point2f way_left = pair.left_px.back() - pair.left_px.front();
  const cv::Point2f way_right = pair.right_px.back() - pair.right_px.front();
  if (way_left.dot(way_right) < 0.0F) std::reverse(pair.right_px.begin(), pair.right_px.end());
  return pair;
}

}  // namespace striate::evaluation
