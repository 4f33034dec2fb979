#pragma once

#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

/// The shipped surfaces and pictures, painted by program when a world first asks for them.
namespace striate::simulator::render {

/// A surface that repeats. Display values (square root of the albedo), BGR.
struct Surface {
  std::string name;
  double tile_x_m = 1.0;  ///< what one repeat covers of the wall
  double tile_y_m = 1.0;
  double gloss = 0.0;  ///< 0 matt .. 1 polished: weight of the mirror image
  cv::Mat3b (*paint)() = nullptr;
};

/// A picture that is stretched over what it is put on: posters, book covers, sides of boxes.
struct Picture {
  std::string name;
  cv::Mat3b (*paint)() = nullptr;
};

[[nodiscard]] const std::vector<Surface>& surfaces();
[[nodiscard]] const std::vector<Picture>& posters();
[[nodiscard]] const std::vector<Picture>& pictures();  ///< posters and what things are wrapped in

}  // namespace striate::simulator::render
