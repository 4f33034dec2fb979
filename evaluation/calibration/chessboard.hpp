#pragma once

#include <opencv2/core/mat.hpp>
#include <optional>
#include <string>
#include <vector>

namespace striate::evaluation {

/// The board in front of the cameras: corners where four squares meet, not squares.
struct Chessboard {
  int columns = 9;
  int rows = 6;
  double square_m = 0.025;
};

/// One look of both cameras at the board.
struct BoardPair {
  std::string name;
  std::vector<cv::Point2f> left_px;
  std::vector<cv::Point2f> right_px;
};

/// The board's corners in its own plane, in metres, in the order in which they are found.
[[nodiscard]] std::vector<cv::Point3f> corners_of(const Chessboard& board);

/// Empty: one of the images does not show the whole board.
[[nodiscard]] std::optional<BoardPair> find_board(const cv::Mat1b& left, const cv::Mat1b& right,
                                                  const Chessboard& board);

}  // namespace striate::evaluation
