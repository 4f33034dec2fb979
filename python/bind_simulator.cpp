#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <cmath>
#include <filesystem>
#include <mutex>

#include "striate/agent/simulated_body.hpp"
#include "striate/base/user_error.hpp"
#include "striate/platform/simulator/start_place.hpp"
#include "striate/platform/simulator/world_reader.hpp"
#include "striate/python/bindings.hpp"
#include "striate/python/felt.hpp"
#include "striate/python/files.hpp"
#include "striate/python/texts.hpp"

namespace striate::python {
namespace {

namespace fs = std::filesystem;

/// The simulated Pioneer, a step at a time.
class SteppedWorld {
 public:
  using Body = agent::SimulatedBody;

  SteppedWorld(const fs::path& world, std::uint64_t seed, const fs::path& robot,
               const std::optional<Pose2>& start) {
    const agent::RobotSettings settings = settings_of(robot);
    agent::WorldOptions options;
    options.world = world_file(world);
    options.seed = seed;
    simulator::World read = simulator::load_world(options.world);
    if (start) {
      simulator::check_place(read, "the start", *start,
                             simulator::robot_footprint(RobotDescription{}));
      read.start = *start;
    }
    body_ = std::make_unique<agent::SimulatedBody>(settings, std::move(read), options);
  }

  SharedSenses step(const MotorCommand& command) {
    for (const double value :
         {command.forward_m_s, command.turn_rad_s, command.pan_rad, command.tilt_rad}) {
      if (!std::isfinite(value)) throw UserError("step: a command is of finite numbers");
    }
    const py::gil_scoped_release unlocked;
    const std::lock_guard one_at_a_time(mutex_);
    body_->send(command);
    over_ = !body_->sense(senses_);
    return copied(senses_);
  }

  /// What `question` finds out of the body, a copy, while no step is made in another thread.
  template <class Question>
  [[nodiscard]] auto ask(Question question) const {
    const py::gil_scoped_release unlocked;
    const std::lock_guard one_at_a_time(mutex_);
    return question(*body_);
  }
  [[nodiscard]] bool over() const {
    const py::gil_scoped_release unlocked;
    const std::lock_guard one_at_a_time(mutex_);
    return over_;
  }
  [[nodiscard]] RobotDescription robot() const {
    return ask([](const Body& body) { return body.description(); });
  }

 private:
  std::unique_ptr<agent::SimulatedBody> body_;
  Senses senses_;
  bool over_ = false;
  mutable std::mutex mutex_;
};

using Body = SteppedWorld::Body;

py::list collisions_of(const SteppedWorld& world) {
  const auto touches = world.ask([](const Body& body) { return body.judge().collisions(); });
  py::list list;
  for (const simulator::Collision& one : touches) {
    py::dict hit;
    hit["time_s"] = one.time_s;
    hit["along_m"] = one.along_m;
    hit["left_m"] = one.left_m;
    hit["hit"] = text_of(one.hit);
    hit["moving"] = one.moving;
    hit["light_level"] = one.light_level;
    list.append(hit);
  }
  return list;
}

/// For a property: what `question` finds out of the body.
template <class Question>
auto asks(Question question) {
  return [question](const SteppedWorld& world) { return world.ask(question); };
}

template <class Class>
void add_truth(Class& world) {
  world
      .def_property_readonly("pose",
                             asks([](const Body& body) { return body.judge().in_corridor(); }),
                             "The true pose in the corridor: x_m along it, y_m to the left of its "
                             "middle. For judging alone: the robot does not know it.")
      .def_property_readonly("collisions", &collisions_of,
                             "A dict for each touch: time_s, along_m, left_m, hit, moving, "
                             "light_level.")
      .def_property_readonly("reached_goal",
                             asks([](const Body& body) { return body.judge().reached_goal(); }),
                             "The goal line was crossed.")
      .def_property_readonly("distance_driven_m", asks([](const Body& body) {
                               return body.judge().distance_driven_m();
                             }))
      .def_property_readonly("clearance_m",
                             asks([](const Body& body) { return body.judge().clearance_m(); }),
                             "From the robot's outline to the nearest thing, now; 0: touching.")
      .def_property_readonly("over", &SteppedWorld::over,
                             "The run has ended: the goal line is crossed, or the time is up.")
      .def_property_readonly("now_s",
                             asks([](const Body& body) { return to_seconds(body.clock().now()); }),
                             "The robot's clock, s: it moves with step() alone.")
      .def_property_readonly("robot", &SteppedWorld::robot, "Its shape and limits.")
      .def_property_readonly(
          "world",
          [](const SteppedWorld& w) {
            return text_of(w.ask([](const Body& body) { return body.world().name; }));
          },
          "Name of the world.")
      .def_property_readonly("start", asks([](const Body& body) { return body.world().start; }),
                             "Where the run began, in the corridor.")
      .def_property_readonly("goal_beyond_m",
                             asks([](const Body& body) { return body.world().goal_beyond_m; }));
}

}  // namespace

void bind_simulator(py::module_& module) {
  py::class_<SteppedWorld> world(
      module, "Simulator",
      "The simulated Pioneer in a world, a step at a time. The same world, seed and commands give "
      "the same senses, bit for bit.\n\nworld: a world file, or the name of a shipped one.  seed: "
      "of people, noise and odometry.  robot: settings file; '': the built-in ones.  start: Pose "
      "along the corridor; None: the world's own.\nRaises UserError with all mistakes of the "
      "world.");
  world
      .def(py::init([](const fs::path& file, std::uint64_t seed, const fs::path& robot,
                       const std::optional<Pose2>& start) {
             const py::gil_scoped_release unlocked;
             return std::make_unique<SteppedWorld>(file, seed, robot, start);
           }),
           py::arg("world"), py::kw_only(), py::arg("seed") = 1, py::arg("robot") = "",
           py::arg("start") = py::none())
      .def(
          "step",
          [](SteppedWorld& self, double forward_m_s, double turn_rad_s, double pan_rad,
             const std::optional<double>& tilt_rad) {
            const double tilt = tilt_rad.value_or(self.robot().resting_tilt_rad);
            return self.step({forward_m_s, turn_rad_s, pan_rad, tilt});
          },
          py::arg("forward_m_s") = 0.0, py::arg("turn_rad_s") = 0.0, py::arg("pan_rad") = 0.0,
          py::arg("tilt_rad") = py::none(),
          "Sends a command and lets one cycle (100 ms) pass.\n\nforward_m_s, turn_rad_s: of the "
          "base, counter-clockwise; what the robot cannot do it does as far as it can.  pan_rad, "
          "tilt_rad: of the head; tilt None: as it rests.\nReturns Senses. No safety limiter "
          "stands "
          "between: a mission has one. Raises UserError for what is no number.");
  add_truth(world);
}

}  // namespace striate::python
