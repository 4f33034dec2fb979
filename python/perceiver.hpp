#pragma once

#include <pybind11/pybind11.h>

#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "striate/app/own_camera.hpp"
#include "striate/app/perceive_options.hpp"
#include "striate/python/seen.hpp"

namespace striate::python {

/// `striate perceive` for one image pair after the other, by the same functions.
class Perceiver {
 public:
  /// @throws UserError for options that cannot be, and for a calibration that is none
  explicit Perceiver(app::PerceiveOptions options);

  /// @param left, right arrays, see bgr_image(); `right` may be None
  /// @throws py::type_error, UserError for what cannot be seen
  [[nodiscard]] SharedSeen see(const pybind11::object& left, const pybind11::object& right,
                               const std::string& channels);

  /// What was assumed of the calibration, a sentence each.
  [[nodiscard]] std::vector<std::string> remarks() const;

 private:
  [[nodiscard]] SharedSeen judge(StereoFrame frame);
  const app::OwnCamera& camera_for(cv::Size pictures);

  app::PerceiveOptions options_;
  std::optional<datasets::StereoModel> model_;
  std::optional<app::OwnCamera> camera_;  ///< its tables are made once for a size
  cv::Size camera_size_;
  std::mutex mutex_;
};

}  // namespace striate::python
