#pragma once

#include <vector>

#include "striate/perception/visual_odometry/features.hpp"

namespace striate::perception {

struct FeatureMatchSettings {
  double row_px = 2.0;           ///< that the eyes' rows may differ, of the finest keypoints
  double most_disparity = 0.25;  ///< of the width: nearer things are not matched
  double most_ratio = 0.85;      ///< of the distance to that of the second best (Lowe 2004)
  double most_scale = 1.5;       ///< ratio of two scales: half an octave either way, and a little
};

/// Features by their place, for those who ask what is near.
class FeatureGrid {
 public:
  FeatureGrid(const FeatureSet& set, cv::Size image);

  /// Calls take(index) for each feature in the cells that the box touches, in a fixed order.
  template <class Take>
  void visit(double from_u, double to_u, double from_v, double to_v, Take take) const {
    for (int y = row_at(from_v); y <= row_at(to_v); ++y) {
      for (int x = column_at(from_u); x <= column_at(to_u); ++x) {
        for (const std::size_t k : cells_[static_cast<std::size_t>(y * columns_ + x)]) take(k);
      }
    }
  }

 private:
  [[nodiscard]] int column_at(double u_px) const;
  [[nodiscard]] int row_at(double v_px) const;
  int columns_ = 1, rows_ = 1;
  std::vector<std::vector<std::size_t>> cells_;
};

/// Where to look for a feature.
struct LookedFor {
  std::size_t feature = 0;
  double u_px = 0.0;
  double v_px = 0.0;
};

struct FeaturePair {
  std::size_t from = 0;
  std::size_t to = 0;
};

/// Of each left feature the right one of the same thing: on its row, not left of where nearness
/// ends, each the other's best by far.
[[nodiscard]] std::vector<FeaturePair> match_eyes(const FeatureSet& left, const FeatureSet& right,
                                                  const FeatureGrid& right_grid, cv::Size image,
                                                  double doffs_px,
                                                  const FeatureMatchSettings& settings);

/// Of each feature the one of the same thing within `radius_px` of where it is looked for.
[[nodiscard]] std::vector<FeaturePair> match_near(const FeatureSet& then,
                                                  const std::vector<LookedFor>& looked_for,
                                                  const FeatureSet& now,
                                                  const FeatureGrid& now_grid, double radius_px,
                                                  const FeatureMatchSettings& settings);

}  // namespace striate::perception
