#include "striate/agent/plugins/plugin.hpp"

#include <algorithm>
#include <limits>

using namespace striate;

/// Holds once memory knows of something that stands straight ahead, nearer than the limit.
class ThingAhead final : public tasks::Condition {
 public:
  explicit ThingAhead(double limit_m) : limit_m_(limit_m) {}

  [[nodiscard]] bool holds(const memory::ShortTermMemory& memory) const override {
    const memory::PolarMap map = memory.polar_map();
    for (int ring = 0; ring < memory::PolarMap::kRings; ++ring) {
      if (memory::PolarMap::ring_outer_m(ring) > limit_m_) return false;
      // A sector is five degrees wide; the one to either side is looked at, too.
      for (const int sector : {memory::PolarMap::kSectors - 1, 0, 1}) {
        if (map.at(sector, ring).state == memory::CellState::occupied) return true;
      }
    }
    return false;
  }

 private:
  double limit_m_;
};

void enroll(agent::PluginRegistrar& plugin) {
  plugin.add(tasks::ConditionEntry{.name = "thing_ahead_within",
                                   .help = "something stands straight ahead, nearer than this",
                                   .unit = config::Unit::length,
                                   .range = {0.3, 6.0},
                                   .example = "2 m",
                                   .make = [](double limit_m) -> std::unique_ptr<tasks::Condition> {
                                     return std::make_unique<ThingAhead>(limit_m);
                                   }});
}

STRIATE_PLUGIN("near", enroll)
