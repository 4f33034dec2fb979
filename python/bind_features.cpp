#include <pybind11/stl.h>

#include <memory>
#include <opencv2/core.hpp>

#include "striate/agent/teaching/image_view.hpp"
#include "striate/base/user_error.hpp"
#include "striate/perception/keypoints/keypoints.hpp"
#include "striate/perception/matching/hamming_search.hpp"
#include "striate/perception/v1/v1_cells.hpp"
#include "striate/python/arrays.hpp"
#include "striate/python/bindings.hpp"
#include "striate/python/checked.hpp"
#include "striate/python/descriptors.hpp"

namespace striate::python {
namespace {

using perception::Keypoint;
using perception::V1Responses;
using SharedResponses = std::shared_ptr<const V1Responses>;
using SharedKeypoints = std::shared_ptr<const std::vector<Keypoint>>;

/// Keypoints as Python has them: the records and their descriptors lie in one vector.
struct Keypoints {
  SharedKeypoints points;
};

std::uint32_t limit_of(int below_bits) {
  constexpr int kAll = 257;  // of 256 bits: nothing is as far apart
  if (below_bits < 0 || below_bits > kAll) {
    throw UserError("below_bits " + std::to_string(below_bits) + ": must be 0 to 257");
  }
  return static_cast<std::uint32_t>(below_bits);
}

py::tuple planes_of(
    const SharedResponses& responses,
    const std::array<perception::Plane<std::int16_t>, perception::kOrientations>& planes) {
  py::tuple views(planes.size());
  for (std::size_t i = 0; i < planes.size(); ++i) {
    views[i] = array_view(
        py::dtype::of<std::int16_t>(), {responses->height, responses->width},
        {planes[i].stride() * py::ssize_t{sizeof(std::int16_t)}, py::ssize_t{sizeof(std::int16_t)}},
        planes[i].row(0), responses);
  }
  return views;
}

py::array complex_of(const SharedResponses& responses) {
  const int rows = responses->height;
  cv::Mat1f all(rows * perception::kOrientations, responses->width);
  for (int i = 0; i < perception::kOrientations; ++i) {
    for (int v = 0; v < rows; ++v) {
      const std::int16_t* codes = responses->code[static_cast<std::size_t>(i)].row(v);
      float* to = all[i * rows + v];
      for (int u = 0; u < responses->width; ++u) to[u] = perception::complex_response(codes[u]);
    }
  }
  return array_of(all).attr("reshape")(perception::kOrientations, rows, responses->width);
}

SharedResponses respond(const py::object& image, double wavelength_px, double sigma_factor,
                        double gamma, const std::string& channels) {
  const cv::Mat1b grey = grey_image(image, "image", channels_named(channels));
  perception::V1Settings settings;
  settings.wavelength_px = wavelength_px;
  settings.sigma_factor = sigma_factor;
  settings.gamma = gamma;
  auto responses = std::make_shared<V1Responses>();
  const py::gil_scoped_release unlocked;
  perception::V1Cells(checked(settings)).respond(grey, 0, true, *responses);
  return responses;
}

Keypoints find(const py::object& image, double wavelength_px, int scales, int most,
               double threshold, const std::string& channels) {
  const cv::Mat1b grey = grey_image(image, "image", channels_named(channels));
  perception::KeypointSettings settings;
  settings.wavelength_px = wavelength_px;
  settings.scales = scales;
  settings.most = most;
  settings.threshold = threshold;
  const py::gil_scoped_release unlocked;
  return {
      std::make_shared<std::vector<Keypoint>>(perception::find_keypoints(grey, checked(settings)))};
}

Keypoints to_learn(const py::object& image, const std::string& channels) {
  const cv::Mat1b grey = grey_image(image, "image", channels_named(channels));
  const py::gil_scoped_release unlocked;
  return {std::make_shared<std::vector<Keypoint>>(agent::keypoints_to_learn(grey))};
}

/// @return a vector of its own: the search uses its buffers again
template <class Search>
auto searched(const py::object& queries, const py::object& stored, Search search) {
  const std::vector<perception::Descriptor> asked = descriptors_of(queries, "queries");
  perception::DescriptorStore store;
  store.append(descriptors_of(stored, "stored"));
  perception::HammingSearch hamming;
  const py::gil_scoped_release unlocked;
  const auto found = search(hamming, asked, store);
  return std::vector(found.begin(), found.end());
}

void bind_v1(py::module_& module) {
  py::class_<V1Responses, std::shared_ptr<V1Responses>>(
      module, "V1Responses",
      "Responses of the model of V1 at every pixel; orientation i is i * 22.5 degrees.")
      .def_property_readonly(
          "even", [](const SharedResponses& v1) { return planes_of(v1, v1->even); },
          "Eight (h, w) int16: even simple cells, `gain` times the model's response to grey "
          "0..255.")
      .def_property_readonly(
          "odd", [](const SharedResponses& v1) { return planes_of(v1, v1->odd); },
          "Eight (h, w) int16: odd simple cells, as `even`.")
      .def_property_readonly("complex", &complex_of,
                             "(8, h, w) float32: complex cells, in units of the simple ones; "
                             "computed anew each time.")
      .def_readonly("wavelength_px", &V1Responses::wavelength_px)
      .def_readonly("gain", &V1Responses::gain);
  module.def("v1_responses", &respond, py::arg("image"), py::kw_only(),
             py::arg("wavelength_px") = 4.0, py::arg("sigma_factor") = 0.56, py::arg("gamma") = 0.5,
             py::arg("channels") = "bgr",
             "Simple and complex cells of V1.\n\nimage: (h, w) or (h, w, 3) uint8.\n"
             "wavelength_px: of the Gabor carrier, 3..12.  sigma_factor: envelope's sigma over the "
             "wavelength, 0.2..1.  gamma: shape of the envelope, 0.25..2.\n"
             "Returns V1Responses. Raises UserError for settings out of range.");
}

void bind_keypoints(py::module_& module) {
  py::class_<Keypoints>(module, "Keypoints", "Keypoints of one image, strongest first.")
      .def_property_readonly(
          "points", [](const Keypoints& all) { return records_view(*all.points, all.points); },
          "Structured array (n,): u_px, v_px, wavelength_px, angle_rad, response.")
      .def_property_readonly(
          "descriptors",
          [](const Keypoints& all) { return descriptors_view(*all.points, all.points); },
          "(n, 32) uint8; bit b is bit b % 8 of byte b // 8. A view with strides: "
          "numpy.ascontiguousarray() makes a copy for those who need one.")
      .def("__len__", [](const Keypoints& all) { return all.points->size(); });
  module.def("keypoints", &find, py::arg("image"), py::kw_only(), py::arg("wavelength_px") = 8.0,
             py::arg("scales") = 1, py::arg("most") = 1000, py::arg("threshold") = 0.04,
             py::arg("channels") = "bgr",
             "End-stopped cells with the paper's 256-bit descriptor, as in `striate perceive`.\n\n"
             "image: (h, w) or (h, w, 3) uint8.\nwavelength_px: of the finest scale, 3..24.  "
             "scales: two an octave, 1..13.  most: the strongest so many.  threshold: of the "
             "largest response, 0..1.\nReturns Keypoints. Raises UserError for settings out of "
             "range.");
  module.def("keypoints_to_learn", &to_learn, py::arg("image"), py::kw_only(),
             py::arg("channels") = "bgr",
             "The oriented keypoints with Striate's own 256-bit descriptor that landmarks are "
             "taught and recognised by.\n\nimage: (h, w) or (h, w, 3) uint8.\nReturns Keypoints.");
}

void bind_matching(py::module_& module) {
  module.def(
      "match_nearest",
      [](const py::object& queries, const py::object& stored, int below_bits) {
        const std::uint32_t limit = limit_of(below_bits);
        return records_array(
            searched(queries, stored, [limit](auto& hamming, const auto& asked, const auto& store) {
              return hamming.nearest_two(asked, store, limit);
            }));
      },
      py::arg("queries"), py::arg("stored"), py::kw_only(), py::arg("below_bits") = 257,
      "The two nearest stored descriptors of each query, by Hamming distance; exact.\n\n"
      "queries, stored: (n, 32) and (m, 32) uint8.  below_bits: farther ones do not count.\n"
      "Returns a structured array (n,): first, second (index; 4294967295: none), first_bits, "
      "second_bits (257: none). Raises UserError, TypeError for what are no descriptors.");
  module.def(
      "match_below",
      [](const py::object& queries, const py::object& stored, int below_bits) {
        const std::uint32_t limit = limit_of(below_bits);
        return records_array(
            searched(queries, stored, [limit](auto& hamming, const auto& asked, const auto& store) {
              return hamming.below(asked, store, limit);
            }));
      },
      py::arg("queries"), py::arg("stored"), py::arg("below_bits"),
      "All pairs with a Hamming distance below `below_bits`, by query, then by stored index.\n\n"
      "queries, stored: (n, 32) and (m, 32) uint8.\nReturns a structured array: query, stored, "
      "distance_bits. Raises UserError, TypeError for what are no descriptors.");
}

}  // namespace

void bind_features(py::module_& module) {
  bind_v1(module);
  bind_keypoints(module);
  bind_matching(module);
}

}  // namespace striate::python
