#pragma once

#include <vector>

#include "striate/perception/percept.hpp"

namespace striate::perception {

/// Drops connected pieces that are too small to be things, and those that hardly a pixel of their
/// own tells from another disparity: slats, a chessboard, whose place is a guess. Neighbours along
/// rows and columns belong together where their disparities differ by at most 1 px. Keeps its
/// buffers.
class Speckles {
 public:
  /// @param least_px pieces of fewer pixels become unknown. @param repeated of the map's size, not
  /// 0 where another disparity matches about as well
  void drop(int least_px, const cv::Mat1b& repeated, DisparityMap& map);

 private:
  void join_row(const DisparityMap& map, const cv::Mat1b& repeated, int y);
  int begin_run();
  [[nodiscard]] int piece_of(int run);
  void join(int a, int b);

  /// A run is a part of a row that belongs together.
  std::vector<int> run_of_;  ///< of every pixel; -1: unknown
  std::vector<int> joined_;  ///< of every run: an earlier run of its piece, or itself
  struct Piece {
    int size_px = 0;
    int repeated_px = 0;
  };
  std::vector<Piece> pieces_;  ///< of every run that is itself the first of its piece
};

}  // namespace striate::perception
