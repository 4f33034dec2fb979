#pragma once

#include <opencv2/core/mat.hpp>
#include <optional>

#include "striate/perception/obstacles/view_geometry.hpp"
#include "striate/perception/recognition/landmark_view.hpp"

namespace striate::perception {

/// A thing cut out of its surroundings: what is salient and equally far.
struct ThingRegion {
  cv::Rect box;              ///< that encloses it, in pixels of the working size
  cv::Mat1b mask;            ///< working size; not zero: belongs to it
  double bearing_rad = 0.0;  ///< robot frame, of its middle
  double distance_m = 0.0;   ///< from the axle
  double height_m = 0.0;     ///< of its middle above the floor
};

/// The salient region nearest to the line of sight, cut by disparity. Nothing where there is none
/// within 3 m.
/// @param bearing_rad of the line of sight, robot frame
[[nodiscard]] std::optional<ThingRegion> find_thing(const Percept& percept,
                                                    const ViewGeometry& geometry,
                                                    double bearing_rad);

/// What the camera sees of the thing, at its full size. @param grey the left image.
[[nodiscard]] LandmarkView view_of_thing(const cv::Mat1b& grey, const ThingRegion& thing,
                                         const KeypointSource& find);

/// The box of the thing in the full image.
[[nodiscard]] cv::Rect full_size_box(const ThingRegion& thing, cv::Size image);

}  // namespace striate::perception
