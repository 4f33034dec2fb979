#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "striate/agent/robot_settings.hpp"
#include "striate/behaviours/control/arbiter.hpp"
#include "striate/behaviours/control/safety_limiter.hpp"
#include "striate/memory/short_term/familiar_landmarks.hpp"
#include "striate/memory/short_term/odometry_history.hpp"
#include "striate/memory/short_term/short_term_memory.hpp"
#include "striate/perception/perception.hpp"
#include "striate/platform/interface/robot.hpp"
#include "striate/tasks/executive.hpp"

namespace striate::agent {

/// What one cycle saw, wanted and did: one way out, for the status line, images and tests.
struct CycleTrace {
  Senses senses;
  std::string refused;  ///< why the body's newest image is not the one in `senses`; "": it is
  perception::Percept percept;
  std::vector<memory::LandmarkSighting>
      sightings;  ///< landmarks recognised in an image of this cycle
  std::vector<memory::LandmarkLesson>
      lessons;            ///< what they teach, for the long-term memory to keep
  behaviours::Wish wish;  ///< what the behaviour wanted
  behaviours::MotorOwner driver = behaviours::MotorOwner::nobody;  ///< whose wish it was that drove
  MotorCommand sent;                                               ///< what the limiter let through
  behaviours::LimitReason limited_by = behaviours::LimitReason::none;
};

/// What a memory tells a mission before it starts.
struct MissionKnowledge {
  memory::LandmarkKnowledge landmarks;
  std::optional<memory::MapKnowledge> places;  ///< none: no place is estimated

  /// For the task's `needs: {landmarks: ...}`.
  [[nodiscard]] std::vector<std::string> names() const;
};

/// What a cycle may be made with; all of it may be left out.
struct CycleExtras {
  /// What the long-term memory knows; none: no landmark is looked for, no place is estimated.
  std::optional<MissionKnowledge> knowledge;
  /// A baseline's disparities instead of Striate's own stereo; must live as long as the cycle.
  perception::DisparitySource* disparities = nullptr;
};

/// What the robot does and what holds it back, in words for a person.
[[nodiscard]] std::string doing_text(const behaviours::ShortText& why,
                                     behaviours::LimitReason limited_by);

/// The whole robot: sees, remembers, wants, moves. `cognitive_cycle.cpp` is the place to start.
class CognitiveCycle {
 public:
  /// @throws UserError for settings out of range. Robot and executive must live as long.
  CognitiveCycle(Robot& robot, const RobotSettings& settings, tasks::Executive& executive,
                 const CycleExtras& extras = {});
  /// Whatever ends the program, the motors stand.
  ~CognitiveCycle();
  CognitiveCycle(const CognitiveCycle&) = delete;
  CognitiveCycle& operator=(const CognitiveCycle&) = delete;

  /// What is new about places. @param operating_s operating time now
  [[nodiscard]] memory::MapNews take_map_news(double operating_s) {
    return memory_.take_map_news(operating_s);
  }
  /// After the last step. @param failed whether the mission did
  void close_map(bool failed) { memory_.close_map(failed); }

  /// One cycle; false when the body has ended or the mission is over.
  bool step();

  /// Somebody from outside who may take the wheel, asked once a cycle: goes before the behaviours,
  /// behind guards, and through the same limiter.
  using Pilot = std::function<std::optional<behaviours::Wish>(TimePoint now)>;
  void set_pilot(Pilot pilot) { pilot_ = std::move(pilot); }

  [[nodiscard]] const CycleTrace& trace() const { return trace_; }
  [[nodiscard]] const memory::ShortTermMemory& memory() const { return memory_; }
  [[nodiscard]] const behaviours::SafetyLimiter& limiter() const { return limiter_; }

 private:
  [[nodiscard]] behaviours::Claim claim_of_pilot(TimePoint now) const;

  Robot& robot_;
  tasks::Executive& executive_;
  memory::OdometryHistory odometry_;  ///< an image belongs to the place where it was taken
  perception::Perception perception_;
  memory::ShortTermMemory memory_;
  memory::FamiliarLandmarks landmarks_;
  behaviours::Arbiter arbiter_;
  behaviours::SafetyLimiter limiter_;
  Pilot pilot_;
  CycleTrace trace_;
};

}  // namespace striate::agent
