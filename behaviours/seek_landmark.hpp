#pragma once

#include <cstdint>
#include <string>

#include "striate/behaviours/control/behaviour.hpp"
#include "striate/behaviours/navigation/gaze_round.hpp"
#include "striate/behaviours/navigation/path_follower.hpp"
#include "striate/config/settings.hpp"

namespace striate::behaviours {

/// Looks for a landmark: stands and turns the head to both sides and from salient region to salient
/// region, drives on along the corridor to see more, turns back where it ends. A first recognition
/// is looked at until it is confirmed. Succeeds when the landmark is recognised.
class SeekLandmark : public Behaviour {
 public:
  struct Settings {
    std::string landmark;
    double step_m = 1.2;      ///< by hand: three seconds of driving
    double sweep_rad = 0.96;  ///< with half the view (0.375 rad) 76 degrees to either side
    double dwell_s = 0.6;     ///< by hand: several looks, and three confirm
    int regions = 3;          ///< by hand, of the seven that memory holds
    double speed_m_s = 0.40;  ///< by hand, below the 0.45 m/s of a known corridor
    int turns = 2;            ///< by hand: both ends are seen
    DrivingSettings driving{};
  };
  static constexpr const char* kMain = "landmark";
  static constexpr const char* kRequired[] = {"landmark"};

  SeekLandmark(const Settings& settings, const RobotDescription& robot);
  void start(const memory::ShortTermMemory& memory) override;
  Wish tick(const memory::ShortTermMemory& memory) override;

 private:
  enum class State : std::uint8_t { looking, driving };
  void look_round(const memory::ShortTermMemory& memory);
  Wish look(const memory::ShortTermMemory& memory);
  Wish drive(const memory::ShortTermMemory& memory);
  Wish turn_back(const memory::ShortTermMemory& memory);
  /// A recognition that is not confirmed yet, and fresh; nullptr if there is none.
  [[nodiscard]] const memory::LandmarkInMind* candidate(
      const memory::ShortTermMemory& memory) const;
  [[nodiscard]] bool corridor_ends(const memory::ShortTermMemory& memory);

  Settings settings_;
  RobotDescription robot_;
  GazeRound gaze_;
  PathFollower follower_;
  State state_ = State::looking;
  bool back_ = false;
  int turned_ = 0;
  double driven_from_m_ = 0.0;
  TimePoint open_at_{};       ///< when the way was last open
  TimePoint candidate_at_{};  ///< since when a candidate is looked at
  bool watching_ = false;
};

template <class V>
void visit(V& v, SeekLandmark::Settings& s) {
  using config::Unit;
  v.text("landmark", s.landmark, "the landmark's name");
  v.number("step", s.step_m, Unit::length, {0.3, 10}, "drives on so far between two looks round");
  v.number("sweep", s.sweep_rad, Unit::angle, {0.1, 1.6}, "how far the head turns to each side");
  v.number("dwell", s.dwell_s, Unit::duration, {0.1, 10}, "how long it looks each time");
  v.integer("regions", s.regions, {0, 7}, "salient regions looked at in each look round");
  v.number("speed", s.speed_m_s, Unit::speed, {0.05, 0.75}, "where all is known to be free");
  v.integer("turns", s.turns, {0, 20}, "how often it turns back at an end before it gives up");
  v.section("driving", s.driving);
}

}  // namespace striate::behaviours
