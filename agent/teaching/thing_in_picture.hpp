#pragma once

#include <opencv2/core/mat.hpp>
#include <optional>

namespace striate::agent {

/// The part of a picture that shows the thing.
struct ThingInPicture {
  cv::Rect box;        ///< around it
  cv::Mat1b inside;    ///< of the box's size: not 0 where the thing is
  double share = 0.0;  ///< of the picture, 0..1
};

/// What lies before a patterned background, such as a table, in a photo of it. Ours: the paper
/// tells figure from ground by disparity, of which one photo has none. GrabCut (Rother et al. 2004)
/// is told that the picture's edge is ground and its middle most likely figure. Its answer counts
/// only where it can be trusted: one compact piece whose colours are not those of the rest, and a
/// rest with corners on at least three sides, which would be learned as if they were the thing's. A
/// picture that the thing fills has no such rest.
/// @return nothing: all of the picture is to be kept
[[nodiscard]] std::optional<ThingInPicture> find_thing(const cv::Mat3b& image);

}  // namespace striate::agent
