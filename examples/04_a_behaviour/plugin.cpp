#include "striate/agent/plugins/plugin.hpp"

#include <cmath>
#include <numbers>

using namespace striate;

/// Drives along an arc until it has turned by an angle.
class Arc final : public behaviours::Behaviour {
 public:
  /// The arguments of the action; `visit` below gives them their names, units and ranges.
  struct Settings {
    double by_rad = std::numbers::pi / 6.0;  ///< to the left; negative: to the right
    double radius_m = 1.0;
    double speed_m_s = 0.3;
  };
  static constexpr const char* kMain = "by";  // `- arc: 30 deg` is short for `- arc: {by: 30 deg}`

  Arc(const Settings& settings, const RobotDescription& robot) : settings_(settings) {
    settings_.speed_m_s = std::min(settings_.speed_m_s, robot.max_forward_m_s);
  }

  void start(const memory::ShortTermMemory& memory) override {
    heading_rad_ = memory.pose().heading_rad;
    turned_rad_ = 0.0;
    began_ = memory.now();
  }

  /// Once a cycle. It says what it wants; the safety limiter may let less of it through.
  behaviours::Wish tick(const memory::ShortTermMemory& memory) override {
    turned_rad_ += wrap_angle(memory.pose().heading_rad - heading_rad_);
    heading_rad_ = memory.pose().heading_rad;
    if (std::abs(turned_rad_) >= std::abs(settings_.by_rad)) {
      return behaviours::final_wish(memory, behaviours::Progress::succeeded, "the arc is driven");
    }
    const double should_take_s =
        std::abs(settings_.by_rad) * settings_.radius_m / settings_.speed_m_s;
    if (to_seconds(memory.now() - began_) > 5.0 + 2.0 * should_take_s) {
      return behaviours::final_wish(memory, behaviours::Progress::failed,
                                    "something is in the way");
    }
    behaviours::Wish wish = behaviours::standing_wish(memory, "drives an arc");
    wish.forward_m_s = settings_.speed_m_s;
    wish.turn_rad_s = std::copysign(settings_.speed_m_s / settings_.radius_m, settings_.by_rad);
    return wish;
  }

  [[nodiscard]] behaviours::Motors motors() const override { return behaviours::Motors::wheels; }

 private:
  Settings settings_;
  double heading_rad_ = 0.0;
  double turned_rad_ = 0.0;
  TimePoint began_;
};

template <class V>
void visit(V& v, Arc::Settings& s) {
  using config::Unit;
  v.number("by", s.by_rad, Unit::angle, {-6.3, 6.3}, "how far it turns; negative: to the right");
  v.number("radius", s.radius_m, Unit::length, {0.2, 20.0}, "of the arc");
  v.number("speed", s.speed_m_s, Unit::speed, {0.05, 0.75}, "along it");
}

void enroll(agent::PluginRegistrar& plugin) {
  plugin.add(behaviours::behaviour_entry<Arc>("arc", "drives along an arc"));
}

STRIATE_PLUGIN("arc", enroll)
