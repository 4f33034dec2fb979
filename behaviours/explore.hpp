#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "striate/behaviours/control/behaviour.hpp"
#include "striate/behaviours/navigation/frontier.hpp"
#include "striate/behaviours/navigation/gaze_round.hpp"
#include "striate/behaviours/navigation/journey.hpp"
#include "striate/config/settings.hpp"

namespace striate::behaviours {

/// Drives where memory knows least, mapping as it goes: to the edge of the known floor round which
/// most is unknown, again and again, also round corners. Where no edge is left it looks round,
/// turns on the spot, and goes back to edges that it passed. Succeeds when there is nothing left
/// that it could drive to.
class Explore : public Behaviour {
 public:
  struct Settings {
    double speed_m_s = 0.40;  ///< by hand, below the 0.45 m/s of a known corridor
    double sweep_rad = 1.2;   ///< with half the view (0.375 rad) 90 degrees to either side
    int failures = 6;         ///< by hand, as DrivingSettings::tries
    DrivingSettings driving{};
  };

  Explore(const Settings& settings, const RobotDescription& robot);
  void start(const memory::ShortTermMemory& memory) override;
  Wish tick(const memory::ShortTermMemory& memory) override;
  [[nodiscard]] const KnownFloor& known() const { return finder_.known(); }

 private:
  enum class State : std::uint8_t { driving, looking, turning, returning };
  static constexpr std::size_t kPassed = 32;  ///< by hand: 48 m of corridor at 1.5 m apart
  void enter(State state, const memory::ShortTermMemory& memory);
  void think(const memory::ShortTermMemory& memory);
  void choose(const memory::ShortTermMemory& memory);
  void remember_passed(Point2 place);
  /// The nearest edge that was passed and is still one; false where there is none.
  [[nodiscard]] bool pick_passed(const memory::ShortTermMemory& memory);
  bool tries_again();
  Wish drive(const memory::ShortTermMemory& memory);
  Wish look(const memory::ShortTermMemory& memory);
  Wish turn(const memory::ShortTermMemory& memory);
  Wish go_back(const memory::ShortTermMemory& memory);
  /// Leaves a goal that cannot be reached.
  Wish leave(const memory::ShortTermMemory& memory, Point2 place);

  Settings settings_;
  FloorField field_;
  FrontierFinder finder_;
  GazeRound gaze_;
  Journey journey_;
  State state_ = State::looking;
  TimePoint entered_{};
  TimePoint thought_{};
  Frontier goal_;
  double nearest_m_ = 0.0;  ///< to the goal so far
  TimePoint nearest_at_{};
  TimePoint found_at_{};  ///< when there was a goal last
  int turns_ = 0;
  int failures_ = 0;
  double area_at_round_m2_ = 0.0;  ///< known when all that was given up was tried again
  double turn_left_rad_ = 0.0;
  double last_heading_rad_ = 0.0;
  std::array<Point2, kPassed> passed_{};  ///< edges that were seen and not driven to
  std::size_t passed_count_ = 0;
  Point2 back_to_;
};

template <class V>
void visit(V& v, Explore::Settings& s) {
  using config::Unit;
  v.number("speed", s.speed_m_s, Unit::speed, {0.05, 0.75}, "where all is known to be free");
  v.number("sweep", s.sweep_rad, Unit::angle, {0.1, 1.6}, "how far the head turns to each side");
  v.integer("failures", s.failures, {1, 50}, "goals in a row that it cannot reach before it fails");
  v.section("driving", s.driving);
}

}  // namespace striate::behaviours
