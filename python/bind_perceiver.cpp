#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "striate/platform/datasets/images/read_image.hpp"
#include "striate/python/arrays.hpp"
#include "striate/python/bindings.hpp"
#include "striate/python/perceiver.hpp"

namespace striate::python {
namespace {

namespace fs = std::filesystem;
using Options = app::PerceiveOptions;

/// An option that is not given, or None, is left as the command has it.
/// @throws py::type_error where it is of another kind
template <class Value>
void take(const py::kwargs& given, const char* name, Value& value) {
  if (!given.contains(name) || given[name].is_none()) return;
  try {
    value = given[name].cast<Value>();
  } catch (const py::cast_error&) {
    throw py::type_error(
        fmt::format("{}: {} is of the wrong kind", name, std::string(py::repr(given[name]))));
  }
}

template <class Value>
void take(const py::kwargs& given, const char* name, std::optional<Value>& value) {
  Value known{};
  if (!given.contains(name) || given[name].is_none()) return;
  take(given, name, known);
  value = known;
}

/// One file, or the left one's and the right one's.
std::vector<fs::path> calibration_files(const py::kwargs& given) {
  if (!given.contains("calibration") || given["calibration"].is_none()) return {};
  const py::object files = given["calibration"];
  std::vector<fs::path> paths(1);
  if (py::isinstance<py::list>(files) || py::isinstance<py::tuple>(files)) {
    take(given, "calibration", paths);
  } else {
    take(given, "calibration", paths.front());
  }
  return paths;
}

void check_names(const py::kwargs& given) {
  static const std::vector<std::string> known = {
      "mode",        "width_px",    "candidates",        "focal_px",  "baseline_m",
      "centre_u_px", "centre_v_px", "right_centre_u_px", "doffs_px",  "camera_height_m",
      "tilt_deg",    "near_px",     "calibration",       "rectified", "exchanged"};
  for (const auto& [name, value] : given) {
    const auto key = name.cast<std::string>();
    if (std::find(known.begin(), known.end(), key) != known.end()) continue;
    throw py::type_error("perceive() got an unexpected keyword argument '" + key + "'");
  }
}

Options options_of(const py::kwargs& given) {
  check_names(given);
  Options options;
  options.calibration = calibration_files(given);
  take(given, "mode", options.mode);
  take(given, "width_px", options.width_px);
  take(given, "candidates", options.candidates);
  take(given, "focal_px", options.focal_px);
  take(given, "baseline_m", options.baseline_m);
  take(given, "tilt_deg", options.tilt_deg);
  take(given, "near_px", options.near_px);
  take(given, "rectified", options.rectified);
  take(given, "exchanged", options.exchanged);
  take(given, "centre_u_px", options.centre_u_px);
  take(given, "centre_v_px", options.centre_v_px);
  take(given, "right_centre_u_px", options.right_centre_u_px);
  take(given, "doffs_px", options.doffs_px);
  take(given, "camera_height_m", options.camera_height_m);
  return options;
}

constexpr const char* kPerceiveHelp =
    R"(What the vision finds in an image pair; the same as `striate perceive`, bit for bit.

left, right: (h, w) or (h, w, 3) uint8 of one size, rectified unless `calibration` says how;
    right=None: one eye, so saliency and keypoints alone. Rows may be cut out of a larger array.
channels: 'bgr' as OpenCV has colours, or 'rgb' as others have them.

Keyword arguments are the options of `striate perceive`:
mode: 'robust' or 'paper'.  width_px: working width, 32..640.  candidates: disparities searched.
focal_px, baseline_m: of the camera, px and m; without both, lengths are in baselines.
centre_u_px, centre_v_px: principal point, px; None: the image's middle.
right_centre_u_px, doffs_px: of the right image, where it differs.
calibration: file of both eyes, or [left, right]: OpenCV, ROS, Kalibr, EuRoC, KITTI, Middlebury.
rectified: the images are rectified already.  exchanged: left and right have changed places.
camera_height_m: above the floor; without it there is no free floor.  tilt_deg: up positive.
near_px: threshold of near blobs, px of the working size; 0: from the image.

Returns a Percept. Raises UserError with the command's own sentence for what cannot be seen,
TypeError for what is no array of uint8.)";

}  // namespace

void bind_perceiver(py::module_& module) {
  py::class_<Perceiver>(module, "Perceiver",
                        "perceive() for many pairs of one camera: the calibration is read once. "
                        "Takes the keyword arguments of perceive().")
      .def(py::init(
          [](const py::kwargs& given) { return std::make_unique<Perceiver>(options_of(given)); }))
      .def("see", &Perceiver::see, py::arg("left"), py::arg("right") = py::none(), py::kw_only(),
           py::arg("channels") = "bgr", "One pair; see perceive().")
      .def_property_readonly("remarks", &Perceiver::remarks,
                             "What was assumed of the calibration, a sentence each.");
  module.def(
      "perceive",
      [](const py::object& left, const py::object& right, const std::string& channels,
         const py::kwargs& given) {
        return Perceiver(options_of(given)).see(left, right, channels);
      },
      py::arg("left"), py::arg("right") = py::none(), py::kw_only(), py::arg("channels") = "bgr",
      kPerceiveHelp);
  module.def(
      "read_image",
      [](const fs::path& file) {
        cv::Mat3b image;
        {
          const py::gil_scoped_release unlocked;
          image = datasets::read_any_image(file);
        }
        return array_of(image);
      },
      py::arg("file"),
      "An image file as (h, w, 3) uint8, BGR, as Striate reads it: PNG, JPEG, PGM/PPM, BMP, TIFF "
      "or WebP of 8 or 16 bits, upright.\n\nRaises UserError for what is none.");
  module.def(
      "read_pair",
      [](const fs::path& left, const fs::path& right) {
        datasets::EyePair pair;
        {
          const py::gil_scoped_release unlocked;
          pair = datasets::read_eye_pair(left, right);
        }
        return py::make_tuple(array_of(pair.left), array_of(pair.right));
      },
      py::arg("left"), py::arg("right"),
      "Two image files as one pair: (left, right), each (h, w, 3) uint8, BGR, with the same white."
      "\n\nRaises UserError for what is none, and where the sizes differ.");
}

}  // namespace striate::python
