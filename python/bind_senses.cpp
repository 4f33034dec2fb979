#include <fmt/format.h>

#include "striate/python/arrays.hpp"
#include "striate/python/bindings.hpp"
#include "striate/python/felt.hpp"
#include "striate/python/records.hpp"

namespace striate::python {

SharedSenses copied(const Senses& senses) {
  auto own = std::make_shared<Senses>(senses);
  own->stereo.left = senses.stereo.left.clone();
  own->stereo.right = senses.stereo.right.clone();
  return own;
}

SharedSenses without_images(const Senses& senses) {
  auto own = std::make_shared<Senses>(senses);
  own->stereo.left.release();
  own->stereo.right.release();
  return own;
}

namespace {

using SensesClass = py::class_<Senses, std::shared_ptr<Senses>>;

py::object image_of(const cv::Mat3b& image) {
  if (image.empty()) return py::none();
  return array_of(image);
}

void add_felt_images(SensesClass& senses) {
  senses
      .def_property_readonly(
          "left", [](const SharedSenses& s) { return image_of(s->stereo.left); },
          "Newest left image, (h, w, 3) uint8, BGR; None until one has come.")
      .def_property_readonly(
          "right", [](const SharedSenses& s) { return image_of(s->stereo.right); },
          "The same of the right eye; None for one-eyed bodies, too.")
      .def_property_readonly(
          "image_stamp_s", [](const SharedSenses& s) { return to_seconds(s->stereo.stamp); },
          "Middle of the images' exposure, s.")
      .def_property_readonly("focal_px", [](const SharedSenses& s) { return s->stereo.focal_px; })
      .def_property_readonly("centre_u_px",
                             [](const SharedSenses& s) { return s->stereo.centre_u_px; })
      .def_property_readonly("centre_v_px",
                             [](const SharedSenses& s) { return s->stereo.centre_v_px; })
      .def_property_readonly("baseline_m",
                             [](const SharedSenses& s) { return s->stereo.baseline_m; })
      .def_property_readonly(
          "image_pan_rad", [](const SharedSenses& s) { return s->stereo.head.pan_rad; },
          "Of the head when the images were taken.")
      .def_property_readonly(
          "image_tilt_rad", [](const SharedSenses& s) { return s->stereo.head.tilt_rad; },
          "Of the head when the images were taken.");
}

void add_felt_body(SensesClass& senses) {
  senses
      .def_property_readonly(
          "now_s", [](const SharedSenses& s) { return to_seconds(s->now); },
          "When this was felt, on the robot's clock, s.")
      .def_property_readonly(
          "pose", [](const SharedSenses& s) { return s->odometry.pose; },
          "By odometry, since the body started; drifts.")
      .def_property_readonly("forward_m_s",
                             [](const SharedSenses& s) { return s->odometry.forward_m_s; })
      .def_property_readonly("turn_rad_s",
                             [](const SharedSenses& s) { return s->odometry.turn_rad_s; })
      .def_property_readonly(
          "pan_rad", [](const SharedSenses& s) { return s->head.pan_rad; }, "Of the head, now.")
      .def_property_readonly(
          "tilt_rad", [](const SharedSenses& s) { return s->head.tilt_rad; }, "Of the head, now.")
      .def_property_readonly("battery_v", [](const SharedSenses& s) { return s->battery_v; })
      .def_property_readonly(
          "bumper", [](const SharedSenses& s) { return s->bumper; }, "Something is touched.")
      .def_property_readonly(
          "motors_stalled", [](const SharedSenses& s) { return s->motors_stalled; },
          "A wheel is driven and does not turn.")
      .def_property_readonly(
          "sonar", [](const SharedSenses& s) { return records_view(s->sonar.readings, s); },
          "Structured array (n,): bearing_rad, distance_m (inf: nothing within range).")
      .def_property_readonly(
          "laser", [](const SharedSenses& s) { return records_view(s->laser.readings, s); },
          "Structured array (n,), as `sonar`.");
}

void bind_command(py::module_& module) {
  py::class_<MotorCommand>(module, "Command", "What the motors are told until the next command.")
      .def_readonly("forward_m_s", &MotorCommand::forward_m_s)
      .def_readonly("turn_rad_s", &MotorCommand::turn_rad_s, "Counter-clockwise.")
      .def_readonly("pan_rad", &MotorCommand::pan_rad, "Of the head, left positive.")
      .def_readonly("tilt_rad", &MotorCommand::tilt_rad, "Up positive.")
      .def("__repr__", [](const MotorCommand& c) {
        return fmt::format("Command(forward_m_s={}, turn_rad_s={}, pan_rad={}, tilt_rad={})",
                           c.forward_m_s, c.turn_rad_s, c.pan_rad, c.tilt_rad);
      });
}

}  // namespace

void bind_senses(py::module_& module) {
  bind_command(module);
  SensesClass senses(module, "Senses", "All that a body feels in one cycle. Robot frame.");
  add_felt_images(senses);
  add_felt_body(senses);
}

}  // namespace striate::python
