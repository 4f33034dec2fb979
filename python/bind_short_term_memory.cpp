#include <pybind11/stl.h>

#include "striate/agent/recall/memory_state.hpp"
#include "striate/python/bindings.hpp"
#include "striate/python/json_objects.hpp"
#include "striate/python/lent_parts.hpp"
#include "striate/python/texts.hpp"

namespace striate::python {
namespace {

using MemoryClass = py::class_<LentMemory, std::shared_ptr<LentMemory>>;

void add_own_state(MemoryClass& memory) {
  memory
      .def_property_readonly(
          "now_s", [](const LentMemory& m) { return to_seconds(m.get().now()); },
          "The robot's clock, s.")
      .def_property_readonly(
          "robot", [](const LentMemory& m) { return m.get().robot(); }, "Its shape and limits.")
      .def_property_readonly(
          "pose", [](const LentMemory& m) { return m.get().pose(); }, "Odometry frame.")
      .def_property_readonly("forward_m_s",
                             [](const LentMemory& m) { return m.get().forward_m_s(); })
      .def_property_readonly("turn_rad_s", [](const LentMemory& m) { return m.get().turn_rad_s(); })
      .def_property_readonly("pan_rad", [](const LentMemory& m) { return m.get().head().pan_rad; })
      .def_property_readonly("tilt_rad",
                             [](const LentMemory& m) { return m.get().head().tilt_rad; })
      .def_property_readonly("battery_v", [](const LentMemory& m) { return m.get().battery_v(); })
      .def_property_readonly(
          "bumper", [](const LentMemory& m) { return m.get().bumper(); }, "Something is touched.")
      .def_property_readonly(
          "stalled", [](const LentMemory& m) { return m.get().stalled(); },
          "A wheel is driven and does not turn.")
      .def_property_readonly(
          "distance_travelled_m",
          [](const LentMemory& m) { return m.get().distance_travelled_m(); }, "By odometry.")
      .def_property_readonly(
          "progress_m", [](const LentMemory& m) { return m.get().progress_m(); },
          "Along the corridor's axis since the start; back is negative.")
      .def_property_readonly(
          "action", [](const LentMemory& m) { return text_of(m.get().doing()); },
          "Of the task, in the cycle before; '': none.")
      .def_property_readonly("trajectory", &trajectory_of,
                             "(n, 2) float64: x_m, y_m of where it has been, the start first; "
                             "odometry frame.");
}

void add_seen(MemoryClass& memory) {
  memory
      .def_property_readonly(
          "image_age_s", [](const LentMemory& m) { return m.get().image_age_s(); },
          "Since the newest image; inf before the first.")
      .def_property_readonly(
          "light_level", [](const LentMemory& m) { return m.get().light_level(); }, "0..1")
      .def_property_readonly(
          "noise_level", [](const LentMemory& m) { return m.get().noise_level(); },
          "Grey levels of 255.")
      .def_property_readonly(
          "seen_share", [](const LentMemory& m) { return m.get().seen_share(); },
          "Share of the newest image's columns that know anything, slowly averaged.")
      .def(
          "figure",
          [](const LentMemory& m, const std::string& name) { return m.get().figure(name); },
          py::arg("name"),
          "What a stage of a plugin found in the newest image, 'STAGE.FIGURE'; nan: not known.")
      .def_property_readonly(
          "corridor", [](const LentMemory& m) { return object_of(agent::corridor_state(m.get())); },
          "Dict: axis_rad (robot frame), offset_left_m (of the robot from the middle), width_m, "
          "width_known, left_wall_m, right_wall_m (inf: not seen), progress_m.")
      .def_property_readonly(
          "salient_regions",
          [](const LentMemory& m) { return object_of(agent::salient_regions_state(m.get())); },
          "A dict each: id, bearing_rad, distance_m (inf: unknown), size_rad, salience, hits, "
          "activation, seen_s_ago, inhibited (looked at lately).")
      .def_property_readonly(
          "landmarks",
          [](const LentMemory& m) { return object_of(agent::landmarks_state(m.get())); },
          "A dict each: name, sightings, confirmed, score, bearing_rad, distance_m, sigma_m (of "
          "its place), seen_s_ago (None: unknown).")
      .def("polar_map", &polar_of,
           "The egocentric map. Dict of arrays: state (72, 16) uint8 (0 unknown, 1 free, 2 "
           "occupied), log_odds, age_s, moving (72, 16) float32, to_m (16,) outer edges of the "
           "rings, bearing_rad (72,) middles of the sectors, the first straight ahead.")
      .def("grid", &grid_of,
           "The evidence about the floor: (256, 256) float32 log-odds of cells of GRID_CELL_M, "
           "0: unknown; [row, column] grow with y and x of the odometry frame, the robot is in the "
           "middle.");
}

}  // namespace

void bind_short_term_memory(py::module_& module) {
  module.attr("GRID_CELL_M") = memory::LocalGrid::kCell_m;
  MemoryClass memory(
      module, "ShortTermMemory",
      "What the robot knows here and now. Lent to a behaviour, a condition, a pilot or a "
      "callback for one call; asked later it raises RuntimeError.");
  add_own_state(memory);
  add_seen(memory);
}

}  // namespace striate::python
