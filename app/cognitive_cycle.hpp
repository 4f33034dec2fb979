#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/robot_settings.hpp"
#include "behaviours/arbiter.hpp"
#include "behaviours/safety_limiter.hpp"
#include "memory/familiar_landmarks.hpp"
#include "memory/odometry_history.hpp"
#include "memory/short_term_memory.hpp"
#include "perception/perception.hpp"
#include "platform/interface/robot.hpp"
#include "tasks/executive.hpp"

namespace striate {

/// What one cycle saw, wanted and did: one way out, for the status line, pictures and tests.
struct CycleTrace {
  Senses senses;
  Percept percept;
  std::vector<LandmarkSighting> sightings;  ///< landmarks recognised in a picture of this cycle
  std::vector<LandmarkLesson> lessons;      ///< what they teach, for the long-term memory to keep
  Wish wish;                                ///< what the behaviour wanted
  MotorOwner driver = MotorOwner::nobody;   ///< whose wish it was that drove
  MotorCommand sent;                        ///< what the limiter let through
  LimitReason limited_by = LimitReason::none;
};

/// What a memory tells a mission before it starts.
struct MissionKnowledge {
  LandmarkKnowledge landmarks;
  std::optional<PlaceKnowledge> places;  ///< none: no place is estimated

  /// For the task's `needs: {landmarks: ...}`.
  [[nodiscard]] std::vector<std::string> names() const;
};

/// What a cycle may be made with; all of it may be left out.
struct CycleExtras {
  /// What the long-term memory knows; none: no landmark is looked for, no place is estimated.
  std::optional<MissionKnowledge> knowledge;
  /// A baseline's disparities instead of Striate's own stereo; must live as long as the cycle.
  DisparitySource* disparities = nullptr;
};

/// What the robot does and what holds it back, in words for a person.
[[nodiscard]] std::string doing_text(const ShortText& why, LimitReason limited_by);

/// The whole robot: sees, remembers, wants, moves. `cognitive_cycle.cpp` is the place to start.
class CognitiveCycle {
 public:
  /// @throws UserError for settings out of range. Robot and executive must live as long.
  CognitiveCycle(Robot& robot, const RobotSettings& settings, Executive& executive,
                 const CycleExtras& extras = {});
  /// Whatever ends the program, the motors stand.
  ~CognitiveCycle();
  CognitiveCycle(const CognitiveCycle&) = delete;
  CognitiveCycle& operator=(const CognitiveCycle&) = delete;

  /// What is new about places. @param operating_s operating time now
  [[nodiscard]] PlaceNews take_place_news(double operating_s) {
    return memory_.take_place_news(operating_s);
  }
  /// After the last step. @param failed whether the mission did
  void close_places(bool failed) { memory_.close_places(failed); }

  /// One cycle; false when the body has ended or the mission is over.
  bool step();

  /// Somebody from outside who may take the wheel, asked once a cycle: goes before the behaviours,
  /// behind guards, and through the same limiter.
  using Pilot = std::function<std::optional<Wish>(TimePoint now)>;
  void set_pilot(Pilot pilot) { pilot_ = std::move(pilot); }

  [[nodiscard]] const CycleTrace& trace() const { return trace_; }
  [[nodiscard]] const ShortTermMemory& memory() const { return memory_; }
  [[nodiscard]] const SafetyLimiter& limiter() const { return limiter_; }

 private:
  [[nodiscard]] Claim claim_of_pilot(TimePoint now) const;

  Robot& robot_;
  Executive& executive_;
  OdometryHistory odometry_;  ///< a picture belongs to the place where it was taken
  Perception perception_;
  ShortTermMemory memory_;
  FamiliarLandmarks landmarks_;
  Arbiter arbiter_;
  SafetyLimiter limiter_;
  Pilot pilot_;
  CycleTrace trace_;
};

}  // namespace striate
