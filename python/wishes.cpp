#include "striate/python/wishes.hpp"

#include <fmt/format.h>
#include <pybind11/stl.h>

#include <array>
#include <cmath>
#include <utility>

#include "striate/base/user_error.hpp"
#include "striate/python/texts.hpp"

namespace striate::python {
namespace {

namespace py = pybind11;
using behaviours::Progress;

constexpr std::array<std::pair<Progress, const char*>, 3> kProgresses{
    {{Progress::running, "running"},
     {Progress::succeeded, "succeeded"},
     {Progress::failed, "failed"}}};

/// @throws UserError for another
Progress progress_named(const std::string& name) {
  for (const auto& [progress, known] : kProgresses) {
    if (name == known) return progress;
  }
  throw UserError(fmt::format("progress '{}': choose running, succeeded or failed", name));
}

const char* progress_name(Progress progress) {
  for (const auto& [known, name] : kProgresses) {
    if (known == progress) return name;
  }
  return "running";
}

}  // namespace

behaviours::Wish wish_of(const AskedWish& asked, const memory::ShortTermMemory& memory) {
  behaviours::Wish wish = behaviours::standing_wish(memory, std::string_view(asked.why));
  wish.forward_m_s = asked.forward_m_s;
  wish.turn_rad_s = asked.turn_rad_s;
  wish.pan_rad = asked.pan_rad;
  wish.tilt_rad = asked.tilt_rad.value_or(wish.tilt_rad);
  wish.progress = asked.progress;
  for (const double value : {wish.forward_m_s, wish.turn_rad_s, wish.pan_rad, wish.tilt_rad}) {
    if (!std::isfinite(value)) {
      throw UserError(fmt::format(
          "a wish is of finite numbers: forward_m_s {}, turn_rad_s {}, pan_rad {}, tilt_rad {}",
          wish.forward_m_s, wish.turn_rad_s, wish.pan_rad, wish.tilt_rad));
    }
  }
  return wish;
}

AskedWish asked_of(const behaviours::Wish& wish) {
  return {wish.forward_m_s, wish.turn_rad_s, wish.pan_rad,
          wish.tilt_rad,    wish.progress,   std::string(wish.why.view())};
}

const AskedWish& returned_wish(const py::object& given, const std::string& who) {
  if (py::isinstance<AskedWish>(given)) return given.cast<const AskedWish&>();
  throw py::type_error(fmt::format("{} must return a striate.Wish, not {}", who,
                                   std::string(py::str(py::type::of(given).attr("__name__")))));
}

void bind_wish(py::module_& module) {
  py::class_<AskedWish>(
      module, "Wish",
      "What a behaviour or a pilot wants in this cycle.\n\nforward_m_s, turn_rad_s: of the base, "
      "counter-clockwise.  pan_rad, tilt_rad: of the head, left and up; tilt None: as it rests.  "
      "progress: 'running', 'succeeded' or 'failed'.  why: in words for a person, at most 95 "
      "bytes.\nThe safety limiter may let less of it through. Raises UserError for another "
      "progress.")
      .def(py::init([](double forward_m_s, double turn_rad_s, double pan_rad,
                       std::optional<double> tilt_rad, const std::string& progress,
                       const std::string& why) {
             return AskedWish{forward_m_s, turn_rad_s, pan_rad, tilt_rad, progress_named(progress),
                              why};
           }),
           py::arg("forward_m_s") = 0.0, py::arg("turn_rad_s") = 0.0, py::arg("pan_rad") = 0.0,
           py::arg("tilt_rad") = py::none(), py::arg("progress") = "running", py::arg("why") = "")
      .def_readwrite("forward_m_s", &AskedWish::forward_m_s)
      .def_readwrite("turn_rad_s", &AskedWish::turn_rad_s)
      .def_readwrite("pan_rad", &AskedWish::pan_rad)
      .def_readwrite("tilt_rad", &AskedWish::tilt_rad)
      .def_property(
          "progress", [](const AskedWish& wish) { return progress_name(wish.progress); },
          [](AskedWish& wish, const std::string& name) { wish.progress = progress_named(name); },
          "'running', 'succeeded' or 'failed'.")
      .def_property(
          "why", [](const AskedWish& wish) { return text_of(wish.why); },
          [](AskedWish& wish, const std::string& why) { wish.why = why; }, "In words for a person.")
      .def("__repr__", [](const AskedWish& wish) {
        return text_of(fmt::format("Wish(forward_m_s={}, turn_rad_s={}, progress='{}', why='{}')",
                                   wish.forward_m_s, wish.turn_rad_s, progress_name(wish.progress),
                                   wish.why));
      });
}

}  // namespace striate::python
