#include "striate/platform/datasets/calibration/read_sensor_place.hpp"

#include "striate/base/files.hpp"
#include "striate/platform/datasets/calibration/eye_fields.hpp"
#include "striate/platform/datasets/calibration/text_tree.hpp"

namespace striate::datasets {

cv::Matx44d read_sensor_place(const std::filesystem::path& file) {
  config::Diagnostics diagnostics(file.string());
  const config::Node root = read_tree(read_file(file.string()), diagnostics);
  diagnostics.throw_if_any();
  const config::Node* place = first_of(root, {"T_BS"});
  std::optional<cv::Matx44d> motion;
  if (place != nullptr) {
    motion = motion_of(*place, "T_BS", diagnostics);
  } else {
    diagnostics.add(config::fault::missing_key, {}, "'T_BS' is missing",
                    "EuRoC's sensor.yaml of a camera tells it");
  }
  diagnostics.throw_if_any();
  return *motion;
}

}  // namespace striate::datasets
