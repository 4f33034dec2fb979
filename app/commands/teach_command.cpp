#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <memory>

#include "striate/agent/memory_json.hpp"
#include "striate/agent/open_memory.hpp"
#include "striate/agent/robot_settings.hpp"
#include "striate/agent/simulated_body.hpp"
#include "striate/agent/teaching/keep_taught.hpp"
#include "striate/agent/teaching/live_teaching.hpp"
#include "striate/agent/teaching/recorded_teaching.hpp"
#include "striate/app/command_line/found_file.hpp"
#include "striate/app/command_line/whole_number.hpp"
#include "striate/app/commands/commands.hpp"
#include "striate/app/commands/taught_pictures.hpp"
#include "striate/app/interrupt.hpp"
#include "striate/app/plugin_option.hpp"
#include "striate/app/pose_text.hpp"
#include "striate/base/files.hpp"
#include "striate/base/user_error.hpp"
#include "striate/memory/long_term/memory_writer.hpp"
#include "striate/memory/long_term/teaching.hpp"

namespace striate::app {
namespace {

struct TeachOptions {
  std::string name;
  TaughtPictures pictures;
  std::string memory = "home.db";
  std::string robot;              ///< settings file; empty: the defaults
  std::string task;               ///< with a world: to look at a thing there ...
  agent::WorldOptions live;       ///< ... without them it learns from images
  std::string at;                 ///< where the robot starts; empty: the world's start
  std::string from;               ///< a recording to learn from
  std::vector<std::string> when;  ///< times of it; none: where the robot was taught then
  bool yes = false;               ///< nobody is asked
  bool undo = false;
  bool json = false;
};

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

void undo(const TeachOptions& options) {
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

int run(const TeachOptions& options) {
  check_writable(options.memory);
  if (options.undo) {
    if (!options.name.empty() || !options.pictures.images.empty()) {
      throw UserError(
          "--undo takes back what was taught last, whatever it is: give no name and no picture\n"
          "    striate teach --undo --memory home.db");
    }
    undo(options);
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

}  // namespace

void add_teach_command(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<TeachOptions>();
  CLI::App* command = app.add_subcommand(
      "teach",
      "Teaches a landmark by its name, from images of it, by what the simulated robot looks at "
      "or by\n"
      "what a recording shows; it is on the disk when this ends.\n"
      "Examples: striate teach book --image cover.png --image back.png --memory home.db\n"
      "          striate teach red_book --task teach --robot sharp_eyes\n"
      "            --world objects_teach --at \"2 m, 0.2 m, 90 deg\"\n"
      "Says so where the thing looks like a known one, or has too little structure.");
  command->add_option("name", options->name, "the name it gets; a known one gets further views")
      ->type_name("NAME");
  command
      ->add_option("--image", options->pictures.images,
                   "an image that shows the thing, or a folder of such; "
                   "several: several sides")
      ->allow_extra_args(false);
  CLI::Option* crop =
      command
          ->add_option("--crop", options->pictures.crop,
                       "the part of the picture that shows the thing: left, upper, width, height "
                       "in pixels; one for all pictures, or one for each")
          ->type_name("X,Y,W,H")
          ->allow_extra_args(false);
  command
      ->add_flag("--whole", options->pictures.whole,
                 "keep all of the picture; else a thing that clearly stands out from a patterned "
                 "background is cut out")
      ->excludes(crop);
  command->add_option("--task", options->task,
                      "what the robot does to look at the thing ahead of it: a task with 'teach'");
  CLI::Option* world = command->add_option("--world", options->live.world, "where the robot is");
  command
      ->add_option("--at", options->at,
                   "where it starts: along, left of the middle, heading; without it the world's "
                   "start")
      ->type_name("PLACE")
      ->needs(world);
  CLI::Option* from = command->add_option(
      "--from", options->from, "a recording (striate run --record) in which the thing stood ahead");
  command
      ->add_option("--when", options->when,
                   "when it did, as \"12.3 s\"; several: several views; without it "
                   "where the task taught it")
      ->type_name("TIME")
      ->needs(from)
      ->allow_extra_args(false);
  command->add_option("--seed", options->live.seed, "of the run")
      ->check(whole_number_from(0))
      ->needs(world)
      ->capture_default_str();
  command->add_flag("--yes", options->yes, "keep it without asking");
  command->add_option("--memory", options->memory, "the memory; made where there is none")
      ->capture_default_str();
  command->add_option("--robot", options->robot, "settings of the robot and its mind");
  add_plugin_option(*command);
  command->add_flag(
      "--undo", options->undo,
      "takes back the views that were taught last; older ones that made room for them "
      "do not come back");
  command->add_flag("--json", options->json, "print JSON instead of text");
  command->callback([options, &exit_code] {
    find_task(options->task);
    find_world(options->live.world);
    find_robot(options->robot);
    exit_code = run(*options);
  });
}

}  // namespace striate::app
