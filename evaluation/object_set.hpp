#pragma once

#include <opencv2/core/mat.hpp>
#include <set>
#include <string>
#include <vector>

namespace striate::evaluation {

/// What is taught: an image and the part of it that shows the object.
struct TaughtImage {
  cv::Mat1b grey;
  cv::Rect region;
};

struct TaughtObject {
  std::string name;
  std::vector<TaughtImage> pictures;
};

struct ObjectScene {
  std::string name;
  cv::Mat1b grey;
  std::set<std::string> present;     ///< objects to be found
  std::set<std::string> not_judged;  ///< neither a find nor a false alarm: seen from another side
};

struct ObjectSet {
  std::vector<TaughtObject> objects;
  std::vector<ObjectScene> scenes;
};

/// Reads one of three layouts:
/// - `objects/NAME/*.png|jpg`, `scenes/*.png|jpg`, `truth.json`: {"SCENE": ["NAME", ...], ...};
/// - JSK ARC 2017: `objects/NAME/{info.json,top.jpg}`, `scenes/*.jpg`, `visual_annotation.json`;
/// - pairs `NAME.png`, `NAME_in_scene.png`.
/// @throws UserError where none of them is there.
[[nodiscard]] ObjectSet read_object_set(const std::string& folder);

/// The part of an image that differs from its background, where all four corners are of one grey;
/// else the whole image.
[[nodiscard]] cv::Rect region_of_object(const cv::Mat1b& grey);

}  // namespace striate::evaluation
