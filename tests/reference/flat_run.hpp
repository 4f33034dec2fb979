#pragma once

#include <deque>
#include <functional>
#include <string>

#include "striate/behaviours/control/arbiter.hpp"
#include "striate/behaviours/control/behaviour.hpp"
#include "striate/behaviours/control/safety_limiter.hpp"
#include "striate/memory/short_term/short_term_memory.hpp"
#include "tests/reference/flat_camera.hpp"

/// The whole loop in the flat world: see, remember, want, move. As in the judged runs the
/// emergency layer is off: there is neither sonar nor laser here.
namespace striate::flat {

struct RunResult {
  bool reached = false;
  bool touched = false;
  bool touched_person = false;
  behaviours::Progress progress = behaviours::Progress::running;
  double duration_s = 0.0;
  double nearest_m = 0.0;
  Pose2 end;
  std::string why;
};

class Loop {
 public:
  Loop(const Layout& layout, std::uint64_t seed, const CameraErrors& errors = {},
       const RobotDescription& body = {})
      : robot(body),
        world(layout, robot, seed),
        camera(seed, errors, robot),
        memory({}, robot),
        limiter({}, robot) {}

  /// One cycle of 100 ms. Images arrive one cycle after they were taken.
  behaviours::Wish cycle(behaviours::Behaviour& behaviour, const char* name) {
    world.advance(0.1);
    senses.now = TimePoint(std::chrono::milliseconds(100 * ++cycles));
    senses.odometry = {senses.now, world.odometry(), world.forward_m_s(), world.turn_rad_s()};
    senses.head = world.head();
    if (!camera_off) pictures.push_back(camera.look(world, senses.now));
    if (pictures.size() > 1) {
      arrived = std::move(pictures.front());
      pictures.pop_front();
    }
    memory.update(senses, arrived);
    if (recognises) recognises(*this);
    if (cycles == 2) behaviour.start(memory);
    behaviours::Wish wish =
        cycles < 2 ? behaviours::standing_wish(memory, "waits for eyes") : behaviour.tick(memory);
    arbiter.offer(behaviours::MotorOwner::behaviour, wish);
    limited = limiter.limit(arbiter.decide(senses.now), senses, memory);
    memory.remember(limited.command, name, limited.held_by);
    world.send(held ? MotorCommand{} : limited.command);
    return wish;
  }

  RunResult run(behaviours::Behaviour& behaviour, double limit_s,
                const std::function<void(const behaviours::Wish&)>& watch = {}) {
    RunResult result;
    while (world.time_s() < limit_s) {
      const behaviours::Wish wish = cycle(behaviour, "traverse_corridor");
      if (watch) watch(wish);
      result.why = std::string(wish.why.view());
      result.progress = wish.progress;
      result.touched = world.touched();
      result.reached = world.pose().x_m > world.layout().goal_x_m;
      if (result.touched || result.reached || wish.progress != behaviours::Progress::running) break;
    }
    result.touched_person = world.touched_person();
    result.duration_s = world.time_s();
    result.nearest_m = world.nearest_m();
    result.end = world.pose();
    return result;
  }

  RobotDescription robot;
  World world;
  Camera camera;
  memory::ShortTermMemory memory;
  behaviours::SafetyLimiter limiter;
  behaviours::Arbiter arbiter;
  behaviours::Limited limited;  ///< in the last cycle
  Senses senses;
  perception::Percept arrived;
  std::deque<perception::Percept> pictures;
  int cycles = 0;
  bool camera_off = false;
  std::function<void(Loop&)> recognises;  ///< puts sightings into memory
  bool held = false;                      ///< something lets no motion through
};

}  // namespace striate::flat
