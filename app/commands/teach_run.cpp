#include "striate/app/commands/teach_run.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <iostream>

#include "striate/agent/memory_json.hpp"
#include "striate/agent/open_memory.hpp"
#include "striate/agent/robot_settings.hpp"
#include "striate/agent/simulated_body.hpp"
#include "striate/agent/teaching/keep_taught.hpp"
#include "striate/agent/teaching/live_teaching.hpp"
#include "striate/agent/teaching/recorded_teaching.hpp"
#include "striate/app/commands/taught_pictures.hpp"
#include "striate/app/interrupt.hpp"
#include "striate/app/pose_text.hpp"
#include "striate/base/files.hpp"
#include "striate/base/user_error.hpp"
#include "striate/memory/long_term/memory_writer.hpp"
#include "striate/memory/long_term/teaching.hpp"

namespace striate::app {
namespace {

void print_taught(const TeachOptions& options, const memory::Taught& taught) {
  if (options.json) {
    fmt::print("{}", agent::print_json({{"name", options.name},
                                        {"new", taught.is_new},
                                        {"restored", taught.restored},
                                        {"views_added", taught.added},
                                        {"views_merged", taught.merged},
                                        {"remarks", taught.remarks}}));
    return;
  }
  fmt::print("{}: {}, {} view{} added{}; kept in {}\n", options.name,
             taught.is_new     ? "new"
             : taught.restored ? "was forgotten and is back"
                               : "known",
             taught.added, taught.added == 1 ? "" : "s",
             taught.merged > 0 ? fmt::format(", {} like known ones", taught.merged) : "",
             options.memory);
  for (const std::string& remark : taught.remarks) fmt::print("  {}\n", remark);
}

void teach_images(const TeachOptions& options) {
  memory::check_landmark_name(options.name);
  const memory::LongTermSettings settings =
      agent::load_robot_settings(options.robot).long_term_memory;
  const PictureViews seen = views_of_pictures(options.pictures, settings);
  const memory::Taught taught =
      agent::keep_taught(options.memory, options.name, seen.views, settings);
  for (const std::string& share : seen.shares) {
    fmt::print(options.json ? stderr : stdout, "{}\n", share);
  }
  print_taught(options, taught);
}

void tell_views(const agent::LiveViews& seen) {
  for (std::size_t k = 0; k < seen.views.size(); ++k) {
    const memory::StoredView& view = seen.views[k];
    fmt::print(stderr, "view {}: {:.0f} x {:.0f} px, {} keypoints, {:.2f} m away\n", k + 1,
               view.width_px, view.height_px, view.keypoints.size(), view.range_m.value_or(0.0));
  }
  if (seen.looked_in_vain > 0) {
    fmt::print(stderr, "{} look{} in vain: nothing stood out there\n", seen.looked_in_vain,
               seen.looked_in_vain == 1 ? "" : "s");
  }
}

/// The person says whether it is to be kept.
bool confirmed(const TeachOptions& options) {
  if (options.yes) return true;
  fmt::print(stderr, "keep it as '{}'? [y/n] ", options.name);
  std::string answer;
  return std::getline(std::cin, answer) && (answer == "y" || answer == "yes");
}

agent::LiveViews views_of_a_run(const TeachOptions& given) {
  TeachOptions options = given;
  if (!options.at.empty()) options.live.start = parse_pose(options.at);
  agent::MissionOptions mission;
  mission.task = options.task;
  mission.robot = options.robot;
  const Interrupt interrupt(Interrupt::BrokenOutput::ends);
  return agent::take_views(mission, agent::simulated_pioneer(options.live),
                           [](const agent::Mission&) { return Interrupt::requested(); });
}

agent::LiveViews views_of_a_recording(const TeachOptions& options) {
  agent::RecordedTeaching recorded{options.from, options.robot, {}};
  for (const std::string& when : options.when)
    recorded.times_s.push_back(parse_time_s("--when", when));
  std::sort(recorded.times_s.begin(), recorded.times_s.end());
  return agent::take_views(recorded);
}

/// What a robot sees or saw. @return exit code
int teach_seen(const TeachOptions& options) {
  memory::check_landmark_name(options.name);
  if (!options.yes && isatty(STDIN_FILENO) == 0) {
    throw UserError("nobody can be asked whether it is to be kept: say --yes");
  }
  const memory::LongTermSettings settings =
      agent::load_robot_settings(options.robot).long_term_memory;
  const agent::LiveViews seen =
      options.from.empty() ? views_of_a_run(options) : views_of_a_recording(options);
  tell_views(seen);
  std::vector<std::string> remarks;
  const std::vector<memory::StoredView> views =
      agent::with_structure(seen.views, settings, remarks);
  for (const std::string& remark : remarks) fmt::print(stderr, "{}\n", remark);
  if (seen.result.outcome != agent::RunOutcome::success || views.empty()) {
    const bool poor = seen.result.outcome == agent::RunOutcome::success;
    fmt::print(stderr, "nothing was kept: {}\n",
               poor ? "too little structure to be recognised" : agent::outcome_text(seen.result));
    return poor ? 1 : agent::row_of(seen.result.outcome).exit_code;
  }
  if (!confirmed(options)) {
    fmt::print(stderr, "nothing was kept\n");
    return 1;
  }
  print_taught(options, agent::keep_taught(options.memory, options.name, views, settings));
  return 0;
}

void take_back(const TeachOptions& options) {
  memory::MemoryFile(options.memory, agent::memory_options(memory::Access::read,
                                                           "striate teach"));  // must be there
  memory::MemoryWriter writer(options.memory,
                              agent::memory_options(memory::Access::session, "striate teach"));
  agent::print_notices(writer.notices());
  std::string done;
  writer.commit([&](memory::MemoryTables& tables) { done = memory::undo_teaching(tables); });
  if (options.json) {
    fmt::print("{}", agent::print_json({{"done", done}}));
  } else {
    fmt::print("{}: {}\n", options.memory, done);
  }
}

}  // namespace

int run_teach(const TeachOptions& options) {
  check_writable(options.memory);
  if (options.undo) {
    if (!options.name.empty() || !options.pictures.images.empty()) {
      throw UserError(
          "--undo takes back what was taught last, whatever it is: give no name and no picture\n"
          "    striate teach --undo --memory home.db");
    }
    take_back(options);
    return 0;
  }
  if (!options.pictures.crop.empty() && options.pictures.images.empty()) {
    throw UserError("--crop says what part of a picture shows the thing: it needs --image");
  }
  const bool live = !options.task.empty() || !options.live.world.empty();
  if (live && (options.task.empty() || options.live.world.empty())) {
    throw UserError("a robot that is to look at something needs --task and --world");
  }
  const int sources =
      (live ? 1 : 0) + (options.from.empty() ? 0 : 1) + (options.pictures.images.empty() ? 0 : 1);
  if (options.name.empty() || sources != 1) {
    throw UserError(
        "what is to be learned, and from which image?\n"
        "    striate teach NAME --image PICTURE --memory home.db\n"
        "    striate teach NAME --from RECORDING --when \"12 s\" --memory home.db\n"
        "    striate teach NAME --task teach --world WORLD --memory home.db");
  }
  if (options.pictures.images.empty()) return teach_seen(options);
  teach_images(options);
  return 0;
}

}  // namespace striate::app
