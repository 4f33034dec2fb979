#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

namespace striate::evaluation {

/// How well a salience map tells where people looked.
struct SaliencyScores {
  double auc_judd = 0.0;  ///< 0.5: by chance. NaN where it is not defined
  double nss = 0.0;       ///< mean of the map, in its standard deviations, at the fixations
  double cc = 0.0;        ///< correlation with the blurred fixation map
};

/// Measures after Bylinskii et al. 2019. @param fixations pixels inside the map.
/// @param blur_px sigma of the fixation map's Gaussian. A map that is flat scores 0.5, 0, 0.
[[nodiscard]] SaliencyScores score_salience(const cv::Mat1f& salience,
                                            const std::vector<cv::Point>& fixations,
                                            double blur_px);

}  // namespace striate::evaluation
