#include "striate/app/commands/compare_replays.hpp"

#include <fmt/format.h>

#include "striate/agent/memory_json.hpp"

namespace striate::app {
namespace {

const char* ending_text(replay::Ending ending) {
  return ending == replay::Ending::cut_off ? "cut off: the run was killed or the disk was full"
                                           : "whole";
}

}  // namespace

void compare(const agent::ReplayMission& mission, Comparison& result) {
  const std::uint64_t number = mission.recorded().number;
  const std::uint64_t expected = result.cycles + result.gaps + 1;
  if (number > expected) {
    if (result.gaps == 0) result.first_gap = expected;
    result.gaps += number - expected;
  }
  ++result.cycles;
  result.lasts_s = to_seconds(mission.recorded().senses.now);
  const std::vector<std::string> found = mission.differences();
  if (found.empty()) return;
  if (result.differing++ > 0) return;
  result.first_cycle = number;
  result.first_s = result.lasts_s;
  result.first = found;
}

void print_text(const agent::ReplayMission& mission, const Comparison& result) {
  const replay::RecordedSetup& setup = mission.setup();
  fmt::print("{} in {}, seed {}, recorded by {}\n", setup.task,
             setup.world.empty() ? "the real world" : setup.world, setup.seed, setup.software);
  fmt::print("  recording   {} cycles, {:.1f} s, {}\n", result.cycles, result.lasts_s,
             ending_text(mission.ending()));
  if (result.gaps > 0) {
    fmt::print(
        "  gaps        {} cycles were not recorded, the first is {}: from there on memory\n"
        "              cannot be the same\n",
        result.gaps, result.first_gap);
  }
  for (const std::string& line : mission.changed_settings()) {
    fmt::print("  setting     {}\n", line);
  }
  if (result.cycles == 0) {
    fmt::print("  decisions   none: the recording holds no cycle\n");
    return;
  }
  if (result.first_cycle == 0) {
    fmt::print("  decisions   the same in all cycles, bit for bit\n");
    return;
  }
  fmt::print("  decisions   differ in {} cycles, first in cycle {} ({:.1f} s):\n", result.differing,
             result.first_cycle, result.first_s);
  for (const std::string& line : result.first) fmt::print("    {}\n", line);
}

void print_as_json(const agent::ReplayMission& mission, const Comparison& result) {
  nlohmann::ordered_json json = {{"task", mission.setup().task},
                                 {"world", mission.setup().world},
                                 {"seed", mission.setup().seed},
                                 {"software", mission.setup().software},
                                 {"cycles", result.cycles},
                                 {"duration_s", result.lasts_s},
                                 {"whole", mission.ending() == replay::Ending::closed},
                                 {"cycles_not_recorded", result.gaps},
                                 {"changed_settings", mission.changed_settings()},
                                 {"identical", result.identical()},
                                 {"differing_cycles", result.differing}};
  if (result.first_cycle > 0) {
    json["first_difference"] = {
        {"cycle", result.first_cycle}, {"time_s", result.first_s}, {"what", result.first}};
  }
  fmt::print("{}", agent::print_json(json));
}

}  // namespace striate::app
