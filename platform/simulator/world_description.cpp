#include "striate/platform/simulator/world_description.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <vector>

#include "striate/platform/simulator/late_obstacles.hpp"
#include "striate/platform/simulator/obstacle_shapes.hpp"
#include "striate/platform/simulator/world_entry.hpp"
#include "striate/platform/simulator/world_names.hpp"

namespace striate::simulator {
namespace {

/// "2 doors", "1 door"; irregular plurals are given.
std::string counted(std::size_t count, const std::string& one, const std::string& many = {}) {
  return fmt::format("{} {}", count, count == 1 ? one : many.empty() ? one + "s" : many);
}

std::string shape_line(const World& world) {
  std::vector<std::string> parts{fmt::format("{} long, {} wide, {} high", metres(world.length_m),
                                             metres(world.width_m), metres(world.height_m))};
  std::size_t wider = 0;
  for (const Widening& other : world.widenings) wider += other.width_m > world.width_m ? 1 : 0;
  const std::size_t narrower = world.widenings.size() - wider;
  if (!world.turns.empty()) parts.push_back(counted(world.turns.size(), "bend"));
  if (wider > 0) parts.push_back(counted(wider, "widening"));
  if (narrower > 0) parts.push_back(counted(narrower, "narrowing"));
  if (!world.pillars.empty()) parts.push_back(counted(world.pillars.size(), "pillar"));
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::string light_line(const World& world) {
  std::vector<std::string> parts;
  if (!world.lights.empty()) {
    const auto [low, high] =
        std::minmax_element(world.lights.begin(), world.lights.end(),
                            [](const LightRow& a, const LightRow& b) { return a.level < b.level; });
    parts.push_back(low->level == high->level
                        ? fmt::format("lamps at {:g}", low->level)
                        : fmt::format("lamps from {:g} to {:g}", low->level, high->level));
  }
  if (!world.windows.empty()) {
    parts.push_back(counted(world.windows.size(), "row of windows", "rows of windows"));
  }
  if (world.sun) parts.emplace_back("sun");
  return parts.empty() ? "none: it is night" : fmt::format("{}", fmt::join(parts, ", "));
}

std::string things_line(const World& world) {
  std::map<std::string, std::size_t> kinds;
  for (const WorldObstacle& thing : world.obstacles) {
    ++kinds[obstacle_kinds()[static_cast<std::size_t>(thing.kind)]];
  }
  std::vector<std::string> parts;
  for (const auto& [kind, count] : kinds) parts.push_back(fmt::format("{} {}", count, kind));
  if (!world.objects.empty()) parts.push_back(counted(world.objects.size(), "thing") + " to find");
  const std::size_t late = late_obstacles_of(world).size();
  if (late > 0) parts.push_back(fmt::format("{} of them put there during the run", late));
  return parts.empty() ? "none" : fmt::format("{}", fmt::join(parts, ", "));
}

/// Lists the settings that are not off.
struct FaultLister {
  std::vector<std::string> parts;
  void number(const char* key, double& field, config::Unit unit, config::Range /*range*/,
              const char* /*help*/) {
    if (field != 0.0) {
      parts.push_back(fmt::format("{} {}", key, config::print_quantity(field, unit)));
    }
  }
};

std::string eyes_line(const World& world) {
  FaultLister lister;
  EyeFaults faults = world.eyes;
  visit(lister, faults);
  return lister.parts.empty() ? "as they should be"
                              : fmt::format("{}", fmt::join(lister.parts, ", "));
}

std::string people_line(const World& world) {
  std::vector<std::string> parts;
  if (!world.walks.empty()) parts.push_back(fmt::format("{} who walk", world.walks.size()));
  if (!world.standers.empty()) parts.push_back(fmt::format("{} who stand", world.standers.size()));
  double per_minute = 0.0;
  for (const StepInFront& step : world.steps_in_front) per_minute += step.per_minute;
  if (per_minute > 0.0) parts.push_back(fmt::format("{:g} a minute step in front", per_minute));
  return parts.empty() ? "none" : fmt::format("{}", fmt::join(parts, ", "));
}

std::string passage_line(const FloorPlan& plan, const Passage& passage) {
  if (passage.width_m <= 0.0) return "none: there is no way from start to goal";
  const Pose2 along = plan.along({passage.at.x_m, passage.at.y_m, 0.0});
  const std::string between = passage.one == passage.other
                                  ? (passage.one == "wall" ? "two walls" : passage.one)
                                  : passage.one + " and " + passage.other;
  return fmt::format("{:.2f} m, {:.1f} m along, between {}", passage.width_m, along.x_m, between);
}

}  // namespace

std::string describe_world(const World& world, const FloorPlan& plan, const Passage& passage) {
  std::string text;
  const auto line = [&](const char* what, const std::string& is) {
    text += fmt::format("  {:<18} {}\n", what, is);
  };
  line("shape", shape_line(world));
  line("narrowest passage", passage_line(plan, passage));
  line("light", light_line(world));
  line("obstacles", things_line(world));
  line("doors", fmt::format("{}", world.doors.size()));
  line("people", people_line(world));
  if (!world.floor_patches.empty()) {
    line("on the floor", counted(world.floor_patches.size(), "patch", "patches"));
  }
  line("eyes", eyes_line(world));
  line("start and goal", fmt::format("{}, {}; beyond {}", metres(world.start.x_m),
                                     metres(world.start.y_m), metres(world.goal_beyond_m)));
  return text;
}

}  // namespace striate::simulator
