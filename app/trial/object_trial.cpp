#include "striate/app/trial/object_trial.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "striate/agent/landmark_knowledge.hpp"
#include "striate/agent/simulated_body.hpp"
#include "striate/agent/teaching/keep_taught.hpp"
#include "striate/agent/teaching/live_teaching.hpp"
#include "striate/agent/teaching/standing_robot.hpp"
#include "striate/app/interrupt.hpp"
#include "striate/app/trial/object_places.hpp"
#include "striate/base/files.hpp"
#include "striate/base/say.hpp"
#include "striate/base/user_error.hpp"
#include "striate/evaluation/report.hpp"
#include "striate/platform/simulator/world_reader.hpp"
#include "striate/tasks/task_reader.hpp"

namespace striate::app {
namespace {

constexpr int kSettlingCycles = 10;  ///< the exposure adapts from image to image
/// Three looks in a row must recognise it, at every second cycle, and one more
constexpr int kLookingCycles = 8;
constexpr double kSameDirection_rad = 0.12;  ///< 7 deg: 0.3 m at 2.5 m; things stand farther apart

/// What came of one object.
struct ObjectTally {
  int views = 0;
  std::size_t keypoints = 0;
  int places = 0, recognised = 0;  ///< places, and those where it was confirmed
  int looks = 0, seen = 0;         ///< images in which it was sought, and those with it
  double farthest_m = 0.0;         ///< at which it was confirmed
  int false_alarms = 0;            ///< confirmed where it is not
};
using ObjectTallies = std::map<std::string, ObjectTally>;

bool is_meant(const ObjectTrialOptions& options, const std::string& name) {
  return options.only.empty() || std::ranges::find(options.only, name) != options.only.end();
}

void check_given(const ObjectTrialOptions& options, const simulator::World& world) {
  if (options.out.empty()) {
    throw UserError("striate trial --objects needs --out\n    e.g. --out out/objects");
  }
  for (const std::string& name : options.only) {
    const auto same = [&](const simulator::WorldObject& object) { return object.name == name; };
    if (std::ranges::none_of(world.objects, same)) {
      throw UserError(fmt::format("{}: there is no object '{}'", world.file, name));
    }
  }
}

void tell(const ObjectTrialOptions& options, const std::string& text) {
  if (!options.quiet) say(stderr, text + "\n");
}

void teach_one(const ObjectTrialOptions& options, const simulator::WorldObject& object,
               const std::string& memory, ObjectTally& outcome) {
  agent::MissionOptions mission;
  mission.task = options.task;
  mission.robot = options.robot;
  agent::WorldOptions world;
  world.world = options.teach_world;
  world.seed = options.seed;
  world.start = teaching_place(object).along;
  const agent::LiveViews seen =
      agent::take_views(mission, agent::simulated_pioneer(world),
                        [](const agent::Mission&) { return Interrupt::requested(); });
  const memory::LongTermSettings settings =
      agent::load_robot_settings(options.robot).long_term_memory;
  std::vector<std::string> remarks;
  const std::vector<memory::StoredView> views =
      agent::with_structure(seen.views, settings, remarks);
  if (!views.empty()) {
    memory::Taught taught = agent::keep_taught(memory, object.name, views, settings);
    outcome.views = taught.added;
    std::ranges::move(taught.remarks, std::back_inserter(remarks));
  }
  for (const memory::StoredView& view : views) outcome.keypoints += view.keypoints.size();
  tell(options,
       fmt::format(
           "taught {}: {} views, {} keypoints{}", object.name, outcome.views, outcome.keypoints,
           seen.result.outcome == agent::RunOutcome::success ? "" : "; " + seen.result.reason));
  for (const std::string& remark : remarks) tell(options, "  " + remark);
}

/// The robot stands at one place and looks; what it recognises is held against what is there.
void seek_from(const ObjectPlace& place, const simulator::World& world,
               agent::CognitiveCycle& cycle, int looks_every, ObjectTallies& outcomes) {
  ObjectTally* sought = outcomes.contains(place.object) ? &outcomes[place.object] : nullptr;
  std::map<std::string, int> wrong;
  int seen = 0;
  for (int k = 0; k < kSettlingCycles + kLookingCycles; ++k) {
    cycle.step();
    if (k < kSettlingCycles) continue;
    for (const memory::LandmarkSighting& sighting : cycle.trace().sightings) {
      const std::string name(sighting.name);
      const std::vector<std::string> there =
          objects_towards(world, place.along, sighting.bearing_rad, kSameDirection_rad);
      if (std::ranges::find(there, name) == there.end()) ++wrong[name];
      if (name == place.object) ++seen;
    }
  }
  for (const auto& [name, times] : wrong) {
    const memory::LandmarkInMind* mind = cycle.memory().landmarks().find(name);
    if (mind != nullptr && mind->confirmed) ++outcomes[name].false_alarms;
  }
  if (sought == nullptr) return;
  ++sought->places;
  sought->looks += kLookingCycles / looks_every;
  sought->seen += seen;
  const memory::LandmarkInMind* mind = cycle.memory().landmarks().find(place.object);
  if (seen == 0 || mind == nullptr || !mind->confirmed) return;
  ++sought->recognised;
  sought->farthest_m = std::max(sought->farthest_m, place.distance_m);
}

void seek_all(const ObjectTrialOptions& options, const std::string& memory,
              ObjectTallies& outcomes) {
  const simulator::World world = simulator::load_world(options.find_world);
  const simulator::FloorPlan plan = simulator::build_floor_plan(world);
  const agent::RobotSettings settings = agent::load_robot_settings(options.robot);
  const memory::LandmarkKnowledge knowledge = agent::read_landmark_knowledge(memory);
  agent::StandingRobot robot(world, plan, settings, options.seed);
  for (const simulator::WorldObject& object : world.objects) {
    // Things that nobody taught are looked at too: they must not be taken for others.
    if (!options.only.empty() && !outcomes.contains(object.name)) continue;
    for (const ObjectPlace& place : seeking_places(object)) {
      if (Interrupt::requested()) return;
      const Pose2 base = plan.at(place.along.x_m, place.along.y_m);
      robot.stand_at({base.x_m, base.y_m, base.heading_rad + place.along.heading_rad});
      tasks::Executive executive(tasks::load_task(options.look_task, robot.description()));
      agent::CognitiveCycle cycle(robot, settings, executive,
                                  {agent::MissionKnowledge{knowledge, {}}});
      seek_from(place, world, cycle, settings.perception.recognition.every, outcomes);
    }
  }
}

evaluation::Report table_of(const ObjectTallies& outcomes) {
  evaluation::Report report("Objects taught live in one world and sought in another",
                            {"object", "views", "keypoints", "recognised", "pictures", "farthest",
                             "false alarms", "paper"});
  for (const auto& [name, one] : outcomes) {
    report.add_row({name, fmt::format("{}", one.views), fmt::format("{}", one.keypoints),
                    fmt::format("{} of {} places", one.recognised, one.places),
                    fmt::format("{} of {}", one.seen, one.looks),
                    fmt::format("{:.1f} m", one.farthest_m), fmt::format("{}", one.false_alarms),
                    "recognised"});
  }
  return report;
}

}  // namespace

int run_object_trial(const ObjectTrialOptions& options) {
  const simulator::World world = simulator::load_world(options.teach_world);
  check_given(options, world);
  std::filesystem::create_directories(options.out);
  const std::string memory = options.out + "/objects.db";
  for (const char* ending : {"", "-wal", "-shm"}) std::filesystem::remove(memory + ending);
  const Interrupt interrupt(Interrupt::BrokenOutput::ends);
  ObjectTallies outcomes;
  for (const simulator::WorldObject& object : world.objects) {
    if (Interrupt::requested()) return 130;
    if (is_meant(options, object.name)) teach_one(options, object, memory, outcomes[object.name]);
  }
  seek_all(options, memory, outcomes);
  if (Interrupt::requested()) return 130;
  const evaluation::Report report = table_of(outcomes);
  fmt::print("{}", report.text());
  write_file(options.out + "/objects.csv", report.csv());
  return std::ranges::all_of(outcomes,
                             [](const auto& entry) {
                               return entry.second.recognised > 0 && entry.second.false_alarms == 0;
                             })
             ? 0
             : 1;
}

}  // namespace striate::app
