#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "striate/platform/datasets/images/read_image.hpp"
#include "striate/python/arrays.hpp"
#include "striate/python/bindings.hpp"
#include "striate/python/perceiver.hpp"

namespace striate::python {
namespace {

namespace fs = std::filesystem;
using Options = app::PerceiveOptions;

/// Keyword arguments, of which each is taken once; what is left in the end nobody knows.
class GivenOptions {
 public:
  /// @param who for messages: "perceive"
  GivenOptions(const py::kwargs& given, std::string who)
      : left_(given.attr("copy")()), who_(std::move(who)) {}

  /// An option that is not given, or None, is left as the command has it.
  /// @throws py::type_error where it is of another kind
  template <class Value>
  void take(const char* name, Value& value) {
    names_.emplace_back(name);
    const py::object given = left_.attr("pop")(name, py::none());
    if (!given.is_none()) value = cast<Value>(name, given);
  }
  template <class Value>
  void take(const char* name, std::optional<Value>& value) {
    Value known{};
    const bool is_there = left_.contains(name) && !left_[name].is_none();
    take(name, known);
    if (is_there) value = known;
  }
  /// One file, or the left one's and the right one's.
  void take(const char* name, std::vector<fs::path>& files) {
    py::object given;
    take(name, given);
    if (!given) return;
    if (py::isinstance<py::list>(given) || py::isinstance<py::tuple>(given)) {
      files = cast<std::vector<fs::path>>(name, given);
    } else {
      files = {cast<fs::path>(name, given)};
    }
  }
  /// @throws py::type_error where something is left
  void finish() const {
    for (const auto& [name, value] : left_) {
      throw py::type_error(fmt::format("{}() got an unexpected keyword argument '{}'", who_,
                                       name.cast<std::string>()));
    }
  }
  /// All that were asked for.
  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }

 private:
  template <class Value>
  static Value cast(const char* name, const py::object& given) {
    try {
      return given.cast<Value>();
    } catch (const py::cast_error&) {
      throw py::type_error(
          fmt::format("{}: {} is of the wrong kind", name, std::string(py::repr(given))));
    }
  }

  py::dict left_;
  std::string who_;
  std::vector<std::string> names_;
};

Options take_options(GivenOptions& given) {
  Options options;
  given.take("mode", options.mode);
  given.take("width_px", options.width_px);
  given.take("candidates", options.candidates);
  given.take("focal_px", options.focal_px);
  given.take("baseline_m", options.baseline_m);
  given.take("centre_u_px", options.centre_u_px);
  given.take("centre_v_px", options.centre_v_px);
  given.take("right_centre_u_px", options.right_centre_u_px);
  given.take("doffs_px", options.doffs_px);
  given.take("camera_height_m", options.camera_height_m);
  given.take("tilt_deg", options.tilt_deg);
  given.take("near_px", options.near_px);
  given.take("calibration", options.calibration);
  given.take("rectified", options.rectified);
  given.take("exchanged", options.exchanged);
  given.finish();
  return options;
}

Options options_of(const py::kwargs& kwargs, const char* who) {
  GivenOptions given(kwargs, who);
  return take_options(given);
}

/// All options by name; tests/python/test_interface.py compares them with those of __init__.pyi.
py::tuple option_names() {
  GivenOptions none(py::kwargs(), "perceive");
  (void)take_options(none);
  return py::tuple(py::cast(none.names()));
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
      .def(py::init([](const py::kwargs& given) {
        return std::make_unique<Perceiver>(options_of(given, "Perceiver"));
      }))
      .def("see", &Perceiver::see, py::arg("left"), py::arg("right") = py::none(), py::kw_only(),
           py::arg("channels") = "bgr", "One pair; see perceive().")
      .def_property_readonly("remarks", &Perceiver::remarks,
                             "What was assumed of the calibration, a sentence each.");
  module.attr("_PERCEIVE_OPTIONS") = option_names();
  module.def(
      "perceive",
      [](const py::object& left, const py::object& right, const std::string& channels,
         const py::kwargs& given) {
        return Perceiver(options_of(given, "perceive")).see(left, right, channels);
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
