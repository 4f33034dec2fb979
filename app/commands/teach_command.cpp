#include <unistd.h>

#include <memory>

#include "striate/agent/simulated_body.hpp"
#include "striate/app/command_line/found_file.hpp"
#include "striate/app/command_line/whole_number.hpp"
#include "striate/app/commands/commands.hpp"
#include "striate/app/commands/teach_run.hpp"
#include "striate/app/plugin_option.hpp"
#include "striate/base/user_error.hpp"
#include "striate/memory/long_term/memory_writer.hpp"
#include "striate/memory/long_term/teaching.hpp"

namespace striate::app {

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
    exit_code = run_teach(*options);
  });
}

}  // namespace striate::app
