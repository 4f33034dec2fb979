#include "striate/tasks/condition_registry.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "striate/base/limits.hpp"
#include "striate/tasks/joined_conditions.hpp"
#include "striate/tasks/landmark_conditions.hpp"

namespace striate::tasks {
namespace {

using config::Unit;

/// Holds from the moment when a figure of memory, counted from the start of the action, has grown
/// to the limit.
template <class Figure>
class GrownBy final : public Condition {
 public:
  explicit GrownBy(double limit) : limit_(limit) {}
  void start(const memory::ShortTermMemory& memory) override { begin_ = Figure::of(memory); }
  [[nodiscard]] bool holds(const memory::ShortTermMemory& memory) const override {
    return Figure::of(memory) - begin_ >= limit_;
  }

 private:
  double limit_;
  double begin_ = 0.0;
};

/// Holds while a figure of memory is at least (or at most) the limit.
template <class Figure, bool kAtLeast>
class Compared final : public Condition {
 public:
  explicit Compared(double limit) : limit_(limit) {}
  [[nodiscard]] bool holds(const memory::ShortTermMemory& memory) const override {
    return kAtLeast ? Figure::of(memory) >= limit_ : Figure::of(memory) <= limit_;
  }

 private:
  double limit_;
};

struct Travelled {
  static double of(const memory::ShortTermMemory& memory) { return memory.distance_travelled_m(); }
};
struct ProgressMade {
  static double of(const memory::ShortTermMemory& memory) { return memory.progress_m(); }
};
struct Time {
  static double of(const memory::ShortTermMemory& memory) { return to_seconds(memory.now()); }
};
struct Light {
  static double of(const memory::ShortTermMemory& memory) { return memory.light_level(); }
};

constexpr double kGreyLevels = 255.0;  // of an image of 8 bits, from black to white
struct Noise {
  static double of(const memory::ShortTermMemory& memory) {
    return memory.noise_level() / kGreyLevels;
  }
};
struct ImageAge {
  static double of(const memory::ShortTermMemory& memory) { return memory.image_age_s(); }
};
struct SeenShare {
  static double of(const memory::ShortTermMemory& memory) { return memory.seen_share(); }
};
/// Before the corridor has been measured no width holds.
template <int kIfUnknown_m>
struct Width {
  static double of(const memory::ShortTermMemory& memory) {
    const memory::CorridorMemory& corridor = memory.corridor();
    return corridor.width_known() ? corridor.width_m() : kIfUnknown_m;
  }
};
/// Share of the charge: from where the safety limiter stands still to a full lead-acid battery,
/// along a straight line. Full where the body does not tell.
struct Charge {
  static double of(const memory::ShortTermMemory& memory) {
    if (memory.battery_v() <= 0.0) return 1.0;
    return std::clamp((memory.battery_v() - kEmptyBattery_v) / (kFullBattery_v - kEmptyBattery_v),
                      0.0, 1.0);
  }
};

/// Holds once the robot has stood still for so long, counted from the start at the earliest.
class StandsFor final : public Condition {
 public:
  explicit StandsFor(double limit_s) : limit_s_(limit_s) {}
  void start(const memory::ShortTermMemory& memory) override { moved_ = memory.now(); }
  [[nodiscard]] bool holds(const memory::ShortTermMemory& memory) const override {
    const bool moves =
        std::abs(memory.forward_m_s()) > kStill_m_s || std::abs(memory.turn_rad_s()) > kStill_rad_s;
    if (moves) moved_ = memory.now();
    return to_seconds(memory.now() - moved_) >= limit_s_;
  }

 private:
  // By hand, as in behaviours/teach.cpp: slower than this it stands.
  static constexpr double kStill_m_s = 0.01;
  static constexpr double kStill_rad_s = 0.02;
  double limit_s_;
  mutable TimePoint moved_;  ///< the newest cycle in which it moved
};

/// From the place where the run began, by odometry.
struct FromStart {
  static double of(const memory::ShortTermMemory& memory) {
    const Pose2& start = memory.trajectory().start();
    return std::hypot(memory.pose().x_m - start.x_m, memory.pose().y_m - start.y_m);
  }
};

template <class Kind>
std::unique_ptr<Condition> make(double value) {
  return std::make_unique<Kind>(value);
}
template <class Figure>
constexpr auto at_least = make<Compared<Figure, true>>;
template <class Figure>
constexpr auto at_most = make<Compared<Figure, false>>;

// What may be asked for, by hand: up to 100 km, a day, and a share of the whole.
constexpr config::Range kLength_m{0.0, 100000.0};
constexpr config::Range kDay_s{0.0, 86400.0};
constexpr config::Range kShare{0.0, 1.0};

/// What time and the robot's own motion change, and nothing else.
std::vector<ConditionEntry> motion_conditions() {
  std::vector<ConditionEntry> entries = {
      {"travelled", "driven so far since the step began, by odometry", Unit::length, kLength_m,
       "58 m", make<GrownBy<Travelled>>},
      {"progress",
       "got on at least so far along the corridor since the mission began",
       Unit::length,
       {-100000.0, 100000.0},
       "44 m",
       at_least<ProgressMade>},
      {"progress_below",
       "got on no further than this: for the way back",
       Unit::length,
       {-100000.0, 100000.0},
       "0.5 m",
       at_most<ProgressMade>},
      {"after", "time since the step began", Unit::duration, kDay_s, "20 s", make<GrownBy<Time>>},
      {"stands_for", "has not moved for so long", Unit::duration, kDay_s, "30 s", make<StandsFor>},
      {"corridor_wider_than", "the corridor, once measured, is wider than this", Unit::length,
       kLength_m, "3 m", at_least<Width<0>>},
      {"corridor_narrower_than", "the corridor, once measured, is narrower than this", Unit::length,
       kLength_m, "1.5 m", at_most<Width<1000000>>},
      {"near_start", "the robot is so near to where the run began", Unit::length, kLength_m,
       "0.6 m", at_most<FromStart>},
  };
  for (ConditionEntry& entry : entries) {
    const bool in_time = entry.name == "after" || entry.name == "stands_for";
    entry.standing = in_time ? WhileStanding::comes : WhileStanding::stays;
  }
  return entries;
}

/// What may change by itself, too.
std::vector<ConditionEntry> figure_conditions() {
  return {
      {"light_below", "the image is darker than this", Unit::fraction, kShare, "20 %",
       at_most<Light>},
      {"light_above", "the image is brighter than this", Unit::fraction, kShare, "60 %",
       at_least<Light>},
      {"noise_above", "the image's noise, of full scale, is more than this", Unit::fraction, kShare,
       "2 %", at_least<Noise>},
      {"image_older_than", "the newest image is older than this", Unit::duration, kDay_s, "250 ms",
       at_least<ImageAge>},
      {"sees_less_than", "the share of the view that tells any distance, slowly averaged, is less",
       Unit::fraction, kShare, "30 %", at_most<SeenShare>},
      {"battery_below", "the battery's charge, judged by its voltage, is less than this",
       Unit::fraction, kShare, "20 %", at_most<Charge>},
  };
}

ConditionRegistry& table() {
  static ConditionRegistry registry = [] {
    std::vector<ConditionEntry> all = motion_conditions();
    for (const auto& more : {figure_conditions(), landmark_conditions()}) {
      all.insert(all.end(), more.begin(), more.end());
    }
    return ConditionRegistry(std::move(all));
  }();
  return registry;
}

}  // namespace

const ConditionRegistry& condition_registry() {
  return table();
}

bool enroll(ConditionEntry entry) {
  return !joins_conditions(entry.name) && find_condition(entry.name) == nullptr &&
         table().add(std::move(entry));
}

const ConditionEntry* find_condition(const std::string& name) {
  return table().find(name == kOldImageOlderThan ? "image_older_than" : name);
}

}  // namespace striate::tasks
