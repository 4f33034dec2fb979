#pragma once

#include <opencv2/core/mat.hpp>

#include "striate/perception/percept.hpp"

namespace striate::perception {

/// How many rows lower the right image shows things than the left one, from a first match: what is
/// left between the eyes along level edges, over how fast they change downwards. 0 where too few
/// such edges say so; right to a tenth of a row within a row and a half.
/// @param left, right of one size and type, CV_8U or CV_16U. @param matched from them
[[nodiscard]] double row_offset_px(const cv::Mat& left, const cv::Mat& right,
                                   const DisparityMap& matched);

/// The same before any match, coarsely: from the means of the rows, which disparities leave nearly
/// as they are. 0 where no offset up to three rows explains the right image's clearly better.
[[nodiscard]] double row_offset_of_means_px(const cv::Mat& left, const cv::Mat& right);

/// The image `rows_px` higher (cubic, Catmull and Rom 1974); what comes in from below is the lowest
/// row. Integer arithmetic, in sixteenths of a row. @param image CV_8U, or CV_16U of fine greys
[[nodiscard]] cv::Mat raised(const cv::Mat& image, double rows_px);

}  // namespace striate::perception
