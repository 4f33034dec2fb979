#include "striate/agent/simulated_body.hpp"

#include <utility>

#include "striate/agent/baselines/baseline.hpp"
#include "striate/config/quantity.hpp"
#include "striate/platform/simulator/start_place.hpp"
#include "striate/platform/simulator/world_reader.hpp"

namespace striate::agent {
namespace {

/// How far to drive is for the person to say: `way` leads to the goal line and a little beyond,
/// `there` ends a little before it, because the robot's own count of its way is not exact.
tasks::GivenVariables course_of(const simulator::World& world) {
  // m: 2.5 % of the 60 m corridor, three times the odometry's error of 0.75 %
  constexpr double kMargin_m = 1.5;
  const double line_m = world.goal_beyond_m - world.start.x_m;
  return {{"way", config::print_quantity(line_m + kMargin_m, config::Unit::length)},
          {"there", config::print_quantity(line_m - kMargin_m, config::Unit::length)}};
}

/// Only the baseline `truth` has images that know their depth.
std::unique_ptr<TrueDepthImages> with_depth(Baseline baseline, simulator::RendererImages& pictures,
                                            const RobotSettings& settings) {
  if (baseline != Baseline::truth) return nullptr;
  return std::make_unique<TrueDepthImages>(pictures, pictures.renderer(),
                                           settings.perception.stereo.width);
}

}  // namespace

SimulatedBody::SimulatedBody(const RobotSettings& settings, simulator::World world,
                             const WorldOptions& options)
    : options_(options),
      world_(std::move(world)),
      plan_(simulator::build_floor_plan(world_)),
      pictures_(world_, plan_, settings.camera, options.seed),
      true_images_(with_depth(baseline_named(options.baseline), pictures_, settings)),
      disparities_(disparities_of(baseline_named(options.baseline), settings.perception,
                                  true_images_.get())),
      body_(world_, options.seed, settings.simulator,
            true_images_ ? static_cast<simulator::ImageSource*>(true_images_.get()) : &pictures_,
            simulated_robot(settings)) {}

BodySource simulated_pioneer(const WorldOptions& options) {
  simulator::World world = simulator::load_world(options.world);
  if (options.start) {
    simulator::check_place(world, "the start", *options.start,
                           simulator::robot_footprint(RobotDescription{}));
    world.start = *options.start;
  }
  const Baseline baseline = baseline_named(options.baseline);
  const auto wake = [options, world, baseline](RobotSettings& settings) -> Body {
    // The goal line ends the task, not the body: `finally` is still to be run.
    settings.simulator.judge.ends_at_goal = false;
    apply_baseline(baseline, settings.perception);
    auto robot = std::make_unique<SimulatedBody>(settings, world, options);
    const SimulatedBody& simulated = *robot;
    return {.robot = std::move(robot),
            .place = options.world,
            .judge = &simulated.judge(),
            .disparities = simulated.disparities(),
            .simulated = &simulated};
  };
  return {.wake = wake, .given = course_of(world)};
}

}  // namespace striate::agent
