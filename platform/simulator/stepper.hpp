#pragma once

#include "striate/platform/simulator/doorways.hpp"
#include "striate/platform/simulator/random.hpp"
#include "striate/platform/simulator/walker.hpp"

namespace striate::simulator {

/// What a stepper knows of the place; lives as long as the run.
struct RobotNearby {
  const World* world = nullptr;
  const FloorPlan* plan = nullptr;
  const ClearanceMap* map = nullptr;
  const std::vector<Doorway>* doors = nullptr;
  RobotDescription robot;
};

/// Somebody who now and then steps in front of the moving robot, waits there, and goes away. He
/// comes out of a door that the robot is about to pass, or, where there is none, from far ahead;
/// always so that the robot can still stop.
class Stepper {
 public:
  Stepper(const StepInFront& step, std::uint64_t seed, std::uint64_t number);

  /// Decides what to do next; several times a second.
  void decide(double now_s, const RobotNearby& place, const Surroundings& around);
  [[nodiscard]] Walker& walker() { return walker_; }
  [[nodiscard]] const Walker& walker() const { return walker_; }

 private:
  enum class Doing { nothing, coming, waiting, leaving };
  void try_to_come(double now_s, const RobotNearby& place, const Surroundings& around);
  [[nodiscard]] bool come_through_a_door(const RobotNearby& place, const Surroundings& around);
  [[nodiscard]] bool come_from_ahead(const RobotNearby& place, const Surroundings& around);
  void leave(const RobotNearby& place, const Surroundings& around);
  void be_gone(double now_s);
  [[nodiscard]] double draw(double low, double high) {
    return random_.between(drawn_++, low, high);
  }

  StepInFront step_;
  Random random_;
  std::uint64_t drawn_ = 0;
  int look_ = 0;
  Walker walker_;
  Doing doing_ = Doing::nothing;
  double due_s_ = 0.0;
  double since_s_ = 0.0;   ///< when the present doing began
  double before_m_ = 1.5;  ///< how far before the robot he wants to stand
  double aside_m_ = 0.0;
  bool through_door_ = false;
};

}  // namespace striate::simulator
