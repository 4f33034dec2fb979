#include <pybind11/stl/filesystem.h>

#include <opencv2/core/utility.hpp>

#include "striate/base/version.hpp"
#include "striate/config/program_folder.hpp"
#include "striate/python/bindings.hpp"

/// The module behind `import striate`.
PYBIND11_MODULE(_striate, module) {
  using namespace striate::python;
  module.doc() = "What the package striate is made of; import that.";
  module.attr("__version__") = striate::kVersion;
  // As the program: images are small, and a robot's cycle must not wait for a busy pool.
  cv::setNumThreads(1);
  module.def("_set_program_folder", [](const std::filesystem::path& folder) {
    striate::config::set_program_folder(folder);
  });
  bind_errors(module);
  bind_geometry(module);
  bind_percept(module);
  bind_perceiver(module);
  bind_features(module);
  bind_senses(module);
  bind_long_term_memory(module);
  bind_recording(module);
  bind_simulator(module);
  bind_short_term_memory(module);
  bind_additions(module);
  bind_mission(module);
}
