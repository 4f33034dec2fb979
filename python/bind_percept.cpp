#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <filesystem>

#include "striate/agent/pictures/overview.hpp"
#include "striate/base/files.hpp"
#include "striate/base/user_error.hpp"
#include "striate/python/arrays.hpp"
#include "striate/python/bindings.hpp"
#include "striate/python/descriptors.hpp"
#include "striate/python/records.hpp"
#include "striate/python/seen.hpp"

namespace striate::python {

SharedSeen seen_of(const perception::Percept& percept) {
  auto seen = std::make_shared<Seen>();
  seen->percept = percept;
  seen->disparity_px = percept.disparity.disparity_px;
  return seen;
}

namespace {

namespace fs = std::filesystem;

const Seen::Judged& judged_of(const Seen& seen) {
  if (seen.judged) return *seen.judged;
  throw UserError(
      "this percept is a running robot's, without the pair that it was seen in\n    "
      "striate.perceive(left, right) makes one that can be drawn and written");
}

void write_seen(const SharedSeen& seen, const fs::path& out, const fs::path& left,
                const fs::path& right) {
  Seen::Judged judged = judged_of(*seen);
  judged.options.left = left;
  judged.options.right = right;
  judged.options.out = out;
  const py::gil_scoped_release unlocked;
  make_folder(out);
  app::write_judged(judged.options, judged.frame, {seen->percept, judged.robot, judged.report});
}

py::array overview_of(const SharedSeen& seen) {
  const Seen::Judged& judged = judged_of(*seen);
  agent::pictures::OverviewStyle style;
  style.metric = judged.report.unit == "m";
  style.unit = style.metric ? "m" : "bl";
  cv::Mat3b picture;
  {
    const py::gil_scoped_release unlocked;
    picture = agent::pictures::draw_overview(judged.frame, seen->percept, judged.robot, style);
  }
  return array_of(picture);
}

/// What `striate perceive` tells of how the obstacles came about; empty for a running robot.
app::ObstacleReport report_of(const SharedSeen& seen) {
  if (seen->judged) return seen->judged->report;
  app::ObstacleReport report;
  report.unit = "m";
  return report;
}

void bind_corridor(py::module_& module) {
  using perception::CorridorView;
  py::class_<CorridorView>(module, "Corridor", "The corridor as one image shows it; robot frame.")
      .def_readonly("heading_rad", &CorridorView::heading_rad, "Of its axis, left positive.")
      .def_readonly("left_m", &CorridorView::left_m,
                    "Distance of the left wall from the axle, m; inf: not seen.")
      .def_readonly("right_m", &CorridorView::right_m, "The same of the right wall, positive.")
      .def_readonly("confidence", &CorridorView::confidence, "0..1");
}

/// Arrays of the working size.
template <class Class>
void add_maps(Class& percept) {
  percept
      .def_property_readonly(
          "disparity_px", [](const SharedSeen& seen) { return array_of(seen->disparity_px); },
          "(h, w) float32 of the working size, left image's frame, pixels; inf: no trusted match. "
          "(0, 0) with one eye. Distance along the axis: focal_px * baseline_m / disparity_px.")
      .def_property_readonly(
          "confidence",
          [](const SharedSeen& seen) { return array_of(seen->percept.disparity.confidence); },
          "(h, w) float32, 0..1: how likely each disparity is right.")
      .def_property_readonly(
          "salience",
          [](const SharedSeen& seen) { return array_of(seen->percept.saliency.salience); },
          "(h, w) float32 of the working size, 0..1.");
}

template <class Class>
void add_records(Class& percept) {
  percept
      .def_property_readonly(
          "columns",
          [](const SharedSeen& seen) { return records_view(seen->percept.columns, seen); },
          "Structured array, one record a column of the working image, left to right: "
          "bearing_rad, free_from_m, free_to_m, free_confidence, obstacle_m, "
          "obstacle_confidence, hidden_from_m, hidden_to_m, moving. inf: nothing there.")
      .def_property_readonly(
          "obstacles",
          [](const SharedSeen& seen) { return records_view(seen->percept.obstacles, seen); },
          "Structured array, nearest first: bearing_rad, distance_m, width_m, height_m, "
          "confidence, from_u_px, to_u_px. Robot frame.")
      .def_property_readonly(
          "moving", [](const SharedSeen& seen) { return records_view(seen->percept.moving, seen); },
          "Structured array of what moves by itself, nearest first: bearing_rad, distance_m, "
          "width_m, confidence, velocity_known, forward_m_s, left_m_s, from_u_px, to_u_px.")
      .def_property_readonly(
          "regions",
          [](const SharedSeen& seen) { return records_view(seen->percept.saliency.regions, seen); },
          "Structured array of salient regions, most salient first: u_px, v_px, width_px, "
          "height_px (working size), salience, bearing_rad, distance_m (inf: unknown).")
      .def_property_readonly(
          "keypoints",
          [](const SharedSeen& seen) { return records_view(seen->percept.keypoints, seen); },
          "Structured array, strongest first: u_px, v_px, wavelength_px, angle_rad, response; in "
          "pixels of the image that was handed in.")
      .def_property_readonly(
          "descriptors",
          [](const SharedSeen& seen) { return descriptors_view(seen->percept.keypoints, seen); },
          "(n, 32) uint8, of each keypoint; bit b is bit b % 8 of byte b // 8.");
}

template <class Class>
void add_numbers(Class& percept) {
  percept
      .def_property_readonly(
          "stamp_s", [](const SharedSeen& seen) { return to_seconds(seen->percept.stamp); },
          "Middle of the exposure on the robot's clock, s; 0 of perceive().")
      .def_property_readonly(
          "corridor",
          [](const SharedSeen& seen) -> std::optional<perception::CorridorView> {
            if (!seen->percept.corridor.valid) return {};
            return seen->percept.corridor;
          },
          "The corridor, or None where none is seen.")
      .def_property_readonly(
          "light_level", [](const SharedSeen& seen) { return seen->percept.light_level; },
          "Mean grey, 0..1.")
      .def_property_readonly(
          "noise_level", [](const SharedSeen& seen) { return seen->percept.noise_level; },
          "Estimated noise of a pixel, grey levels of 255.")
      .def_property_readonly(
          "right_lower_px",
          [](const SharedSeen& seen) { return seen->percept.disparity.right_lower_px; },
          "Rows of the working image by which the right eye showed things lower; made good.")
      .def_property_readonly(
          "focal_px", [](const SharedSeen& seen) { return seen->percept.disparity.focal_px; },
          "Focal length at the working size, px; 0: unknown.")
      .def_property_readonly(
          "centre_u_px", [](const SharedSeen& seen) { return seen->percept.disparity.centre_u_px; },
          "Principal point at the working size, px.")
      .def_property_readonly(
          "centre_v_px", [](const SharedSeen& seen) { return seen->percept.disparity.centre_v_px; },
          "Principal point at the working size, px.")
      .def_property_readonly(
          "baseline_m", [](const SharedSeen& seen) { return seen->percept.disparity.baseline_m; },
          "Distance of the eyes, m; 0: unknown.");
}

template <class Class>
void add_report(Class& percept) {
  percept
      .def_property_readonly(
          "unit", [](const SharedSeen& seen) { return report_of(seen).unit; },
          "Of every length: 'm', or 'baselines' where the camera is unknown.")
      .def_property_readonly(
          "method", [](const SharedSeen& seen) { return report_of(seen).method; },
          "How the obstacles were found, in words.")
      .def_property_readonly(
          "floor_known", [](const SharedSeen& seen) { return report_of(seen).floor_known; },
          "Whether the camera's height is known, so that columns tell free floor.")
      .def_property_readonly(
          "doffs_px", [](const SharedSeen& seen) { return report_of(seen).doffs_px; },
          "How far right of the left principal point the right one lies, px of the working size: "
          "distance is focal_px * baseline_m / (disparity_px + doffs_px).")
      .def_property_readonly(
          "warnings", [](const SharedSeen& seen) { return report_of(seen).warnings; },
          "What speaks against the two images being a rectified pair, a sentence each.")
      .def("write", &write_seen, py::arg("folder"), py::arg("left") = "", py::arg("right") = "",
           "Writes the files of `striate perceive` into a folder: disparity.pfm, confidence.pfm, "
           "obstacles.json, keypoints.json, saliency.png, overview.png.\n\n"
           "left, right: names of the images, for obstacles.json.\n"
           "Raises UserError for a percept of a running robot, RuntimeError where the folder "
           "cannot be written.")
      .def("overview", &overview_of,
           "All of it in one picture, with a floor plan of six metres: (h, w, 3) uint8, "
           "BGR.\n\nRaises UserError for a percept of a "
           "running robot.");
}

}  // namespace

void bind_percept(py::module_& module) {
  describe_records();
  bind_corridor(module);
  py::class_<Seen, std::shared_ptr<Seen>> percept(
      module, "Percept",
      "What the vision found in one image pair. Its arrays are read-only views, made without a "
      "copy, and stay valid when the percept is gone. Robot frame: x forward, y left, from the "
      "wheel axle; images: u right, v down, pixel centres at integers.");
  add_maps(percept);
  add_records(percept);
  add_numbers(percept);
  add_report(percept);
}

}  // namespace striate::python
