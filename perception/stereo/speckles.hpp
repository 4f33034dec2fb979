#pragma once

#include <vector>

#include "striate/perception/percept.hpp"

namespace striate::perception {

/// Drops connected pieces that are too small to be things: neighbours along rows and columns
/// belong together where their disparities differ by at most 1 px. Keeps its buffers.
class Speckles {
 public:
  /// @param least_px pieces of fewer pixels become unknown.
  void drop(int least_px, DisparityMap& map);

 private:
  void join_row(const DisparityMap& map, int y);
  int begin_run();
  [[nodiscard]] int piece_of(int run);
  void join(int a, int b);

  /// A run is a part of a row that belongs together.
  std::vector<int> run_of_;  ///< of every pixel; -1: unknown
  std::vector<int> joined_;  ///< of every run: an earlier run of its piece, or itself
  std::vector<int> size_px_;
};

}  // namespace striate::perception
