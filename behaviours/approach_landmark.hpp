#pragma once

#include <cstdint>
#include <string>

#include "striate/behaviours/control/behaviour.hpp"
#include "striate/behaviours/navigation/journey.hpp"
#include "striate/config/settings.hpp"

namespace striate::behaviours {

/// Drives up to a landmark that was recognised and stops at a distance, facing it: far off like
/// any journey, the last metre straight at it with the eyes on it, because the landmark and what
/// carries it are obstacles themselves. Where things stand nearer than the distance, it goes as
/// near as they allow. Succeeds only when it recognises the landmark from where it stands.
class ApproachLandmark : public Behaviour {
 public:
  struct Settings {
    std::string landmark;
    double stop_at_m = 0.8;   ///< by hand: near enough to recognise it, far enough to turn
    double speed_m_s = 0.30;  ///< by hand: slower than a journey, to see it often
    DrivingSettings driving{};
  };
  static constexpr const char* kMain = "landmark";
  static constexpr const char* kRequired[] = {"landmark"};

  ApproachLandmark(const Settings& settings, const RobotDescription& robot);
  void start(const memory::ShortTermMemory& memory) override;
  Wish tick(const memory::ShortTermMemory& memory) override;

 private:
  enum class State : std::uint8_t { driving, closing, facing };
  void enter(State state, const memory::ShortTermMemory& memory);
  Wish close_in(const memory::ShortTermMemory& memory, const memory::LandmarkInMind& landmark);
  Wish face(const memory::ShortTermMemory& memory, const memory::LandmarkInMind& landmark);
  /// Stands with the eyes on the landmark.
  [[nodiscard]] Wish watch(const memory::ShortTermMemory& memory,
                           const memory::LandmarkInMind& landmark, ShortText why) const;

  Settings settings_;
  RobotDescription robot_;
  Journey journey_;
  FloorField field_;
  Steering steering_;
  Path straight_;
  State state_ = State::driving;
  TimePoint entered_{};
  double nearest_m_ = 0.0;  ///< while it closes in
  TimePoint nearest_at_{};
};

template <class V>
void visit(V& v, ApproachLandmark::Settings& s) {
  using config::Unit;
  v.text("landmark", s.landmark, "the landmark's name");
  v.number("stop_at", s.stop_at_m, Unit::length, {0.4, 5}, "how far from it the robot stops");
  v.number("speed", s.speed_m_s, Unit::speed, {0.05, 0.75}, "where all is known to be free");
  v.section("driving", s.driving);
}

}  // namespace striate::behaviours
