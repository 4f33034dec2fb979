#include "striate/platform/simulator/simulated_pioneer.hpp"

#include <algorithm>
#include <cmath>

#include "striate/platform/simulator/camera_link.hpp"
#include "striate/platform/simulator/dead_reckoning.hpp"
#include "striate/platform/simulator/drive.hpp"
#include "striate/platform/simulator/people.hpp"
#include "striate/platform/simulator/physics.hpp"
#include "striate/platform/simulator/range_finders.hpp"
#include "striate/platform/simulator/start_place.hpp"
#include "striate/platform/simulator/turret.hpp"

namespace striate::simulator {
namespace {

constexpr double kStep_s = 0.010;  // ten steps a SIP cycle; at 0.75 m/s a step is 7.5 mm

class SimulatedClock : public Clock {
 public:
  [[nodiscard]] TimePoint now() const override { return now_; }
  void advance(Duration duration) { now_ += duration; }

 private:
  TimePoint now_;
};

/// Within the deviation that the settings allow, and never beyond twice as much.
Pose2 true_start(const World& world, const FloorPlan& plan, const BaseSettings& settings,
                 std::uint64_t seed) {
  const Random random(seed, Purpose::start_offset);
  const auto off = [&](std::uint64_t index, double deviation) {
    return deviation * std::clamp(random.normal(index), -2.0, 2.0);
  };
  Pose2 pose = plan.at(world.start.x_m + off(0, settings.start_offset_m),
                       world.start.y_m + off(1, settings.start_offset_m));
  pose.heading_rad += world.start.heading_rad + off(2, settings.start_turn_rad);
  return pose;
}

}  // namespace

struct SimulatedPioneer::Parts {
  Parts(const World& world_in, std::uint64_t seed, const SimulatorSettings& settings_in,
        ImageSource* images_in, const RobotDescription& robot_in)
      : robot(robot_in),
        settings(settings_in),
        pictures(images_in),
        world(world_in),
        plan(build_floor_plan(world_in)),
        late(world_in, plan),
        people(world_in, plan, robot, seed),
        physics(world_without(world_in, late.absent()), plan, robot,
                true_start(world_in, plan, settings.base, seed), people.slots().size()),
        drive(robot, settings.base),
        turret(robot, settings.sensors.servo_speed_rad_s),
        odometry(seed, settings.sensors),
        sonar(seed, settings.sensors, robot),
        laser(seed, settings.sensors, robot),
        camera(seed, settings.sensors, settings.faults),
        judge(world_without(world_in, late.absent()), plan, robot, settings.judge),
        command_loss(seed, Purpose::command_loss) {}

  void step();
  void put_down_obstacles();
  void expose();
  void fill(Senses& senses);
  [[nodiscard]] SceneState scene() const;
  [[nodiscard]] double now_s() const { return to_seconds(clock.now()); }

  RobotDescription robot;
  SimulatorSettings settings;
  ImageSource* pictures;
  World world;
  FloorPlan plan;
  LateObstacles late;
  SimulatedClock clock;
  People people;
  Physics physics;
  Drive drive;
  Turret turret;
  DeadReckoning odometry;
  Sonar sonar;
  Laser laser;
  CameraLink camera;
  Judge judge;
  Random command_loss;
  std::uint64_t commands = 0;
  double driven_m = 0.0;
  StereoFrame newest;
};

void SimulatedPioneer::Parts::step() {
  const double before_s = now_s();
  clock.advance(from_seconds(kStep_s));
  put_down_obstacles();
  drive.step(before_s, kStep_s, physics.forward_m_s(), physics.turn_rad_s());
  turret.step(kStep_s, drive.in_force().pan_rad, drive.in_force().tilt_rad);
  people.step(now_s(), kStep_s, {physics.robot(), physics.forward_m_s(), physics.turn_rad_s()});
  physics.step(kStep_s, drive.forward_m_s(), drive.turn_rad_s(), people.bodies());
  // The encoders sit on the wheels, which a thing in the way holds back as it holds the base.
  odometry.step(kStep_s, physics.forward_m_s(), physics.turn_rad_s());
  driven_m += std::abs(physics.forward_m_s()) * kStep_s;
  sonar.step(now_s(), physics);
  judge.look(now_s(), physics, people, pictures);
  if (camera.due(now_s())) expose();
}

void SimulatedPioneer::Parts::put_down_obstacles() {
  if (late.absent().empty()) return;
  const std::vector<std::size_t>& fresh = late.step(now_s(), driven_m, physics.robot());
  if (fresh.empty()) return;
  const World new_ones = world_with_only(world, fresh);
  physics.add_obstacles(new_ones, plan);
  judge.add_obstacles(new_ones);
}

void SimulatedPioneer::Parts::expose() {
  if (pictures == nullptr) return;
  StereoFrame image = pictures->image(scene());
  image.head = turret.reported();
  camera.take(std::move(image), now_s());
}

SceneState SimulatedPioneer::Parts::scene() const {
  SceneState scene;
  scene.time_s = now_s();
  scene.robot = physics.robot();
  scene.forward_m_s = physics.forward_m_s();
  scene.turn_rad_s = physics.turn_rad_s();
  scene.head = turret.true_pose();
  scene.people = people.states();
  scene.absent = late.absent();
  scene.frame = camera.frame();
  return scene;
}

void SimulatedPioneer::Parts::fill(Senses& senses) {
  const TimePoint now = clock.now();
  camera.deliver(now_s(), newest);
  senses.now = now;
  senses.stereo = newest;
  senses.odometry = odometry.reported(now);
  senses.sonar = sonar.scan();
  senses.laser = laser.sweep(now, physics);
  senses.head = turret.reported();
  const double drop = settings.base.battery_drop_v_per_h * now_s() / 3600.0;
  const double driving = settings.base.battery_drop_v_per_h * driven_m / 300.0;
  senses.battery_v = settings.base.battery_start_v - drop - driving;
  senses.bumper = judge.touching();
  senses.motors_stalled = drive.stalled();
}

SimulatedPioneer::SimulatedPioneer(const World& world, std::uint64_t seed,
                                   const SimulatorSettings& settings, ImageSource* pictures,
                                   const RobotDescription& robot)
    : parts_(std::make_unique<Parts>(world, seed, settings, pictures, robot)) {}

SimulatedPioneer::~SimulatedPioneer() = default;

const RobotDescription& SimulatedPioneer::description() const {
  return parts_->robot;
}
const Clock& SimulatedPioneer::clock() const {
  return parts_->clock;
}
const Judge& SimulatedPioneer::judge() const {
  return parts_->judge;
}
SceneState SimulatedPioneer::scene() const {
  return parts_->scene();
}
const FloorPlan& SimulatedPioneer::plan() const {
  return parts_->plan;
}
const LateObstacles& SimulatedPioneer::late_obstacles() const {
  return parts_->late;
}

double SimulatedPioneer::laser_range_m(double bearing_rad) {
  return parts_->laser.range_m(bearing_rad, parts_->physics);
}
bool SimulatedPioneer::put_at(const Pose2& pose) {
  const World there = world_without(parts_->world, parts_->late.absent());
  const ConvexShape body = moved(robot_footprint(parts_->robot), pose);
  if (!inside_polygon({pose.x_m, pose.y_m}, parts_->plan.outline)) return false;
  if (!overlapped_by(there, parts_->plan, body).empty()) return false;
  parts_->physics.put_robot(pose);
  return true;
}

bool SimulatedPioneer::sense(Senses& senses) {
  const TimePoint end = parts_->clock.now() + parts_->robot.cycle;
  while (parts_->clock.now() < end && !parts_->judge.over()) parts_->step();
  parts_->fill(senses);
  return !parts_->judge.over();
}

void SimulatedPioneer::send(const MotorCommand& command) {
  const FaultSettings& faults = parts_->settings.faults;
  const std::uint64_t number = parts_->commands++;
  const double now = parts_->now_s();
  if (faults.link_stops_at_s > 0.0 && now >= faults.link_stops_at_s) return;
  if (parts_->command_loss.uniform(number) < faults.command_loss) return;
  parts_->drive.command(now, command);
}

void SimulatedPioneer::stop() noexcept {
  parts_->drive.stop();
}

}  // namespace striate::simulator
