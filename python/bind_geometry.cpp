#include <fmt/format.h>

#include "striate/base/geometry.hpp"
#include "striate/platform/interface/robot.hpp"
#include "striate/python/bindings.hpp"

namespace striate::python {
namespace {

void bind_pose(py::module_& module) {
  py::class_<Pose2>(module, "Pose",
                    "A place and heading on the floor, m and rad; angles counter-clockwise.")
      .def(py::init<double, double, double>(), py::arg("x_m") = 0.0, py::arg("y_m") = 0.0,
           py::arg("heading_rad") = 0.0)
      .def_readonly("x_m", &Pose2::x_m)
      .def_readonly("y_m", &Pose2::y_m)
      .def_readonly("heading_rad", &Pose2::heading_rad)
      .def("__iter__",
           [](const Pose2& pose) {
             return py::iter(py::make_tuple(pose.x_m, pose.y_m, pose.heading_rad));
           })
      .def(
          "__eq__",
          [](const Pose2& a, const Pose2& b) {
            return a.x_m == b.x_m && a.y_m == b.y_m && a.heading_rad == b.heading_rad;
          },
          py::is_operator())  // anything else is another, not an error
      .def("__repr__", [](const Pose2& pose) {
        return fmt::format("Pose(x_m={}, y_m={}, heading_rad={})", pose.x_m, pose.y_m,
                           pose.heading_rad);
      });
}

void bind_robot(py::module_& module) {
  using Robot = RobotDescription;
  py::class_<Robot>(module, "Robot", "What is fixed about a body: its shape and its limits.")
      .def_readonly("front_m", &Robot::front_m, "From the axle to the front end.")
      .def_readonly("rear_m", &Robot::rear_m, "From the axle to the rear end.")
      .def_readonly("half_width_m", &Robot::half_width_m)
      .def_readonly("max_forward_m_s", &Robot::max_forward_m_s)
      .def_readonly("max_turn_rad_s", &Robot::max_turn_rad_s)
      .def_readonly("max_acceleration_m_s2", &Robot::max_acceleration_m_s2)
      .def_readonly("camera_height_m", &Robot::camera_height_m, "Above the floor.")
      .def_readonly("camera_forward_m", &Robot::camera_forward_m, "Of the pan axis, from the axle.")
      .def_readonly("view_rad", &Robot::view_rad, "The camera's horizontal angle.")
      .def_readonly("resting_tilt_rad", &Robot::resting_tilt_rad, "Of the head, up positive.")
      .def_readonly("max_pan_rad", &Robot::max_pan_rad)
      .def_readonly("max_tilt_rad", &Robot::max_tilt_rad)
      .def_property_readonly(
          "cycle_s", [](const Robot& robot) { return to_seconds(robot.cycle); },
          "Length of a cycle.");
}

}  // namespace

void bind_geometry(py::module_& module) {
  bind_pose(module);
  bind_robot(module);
}

}  // namespace striate::python
