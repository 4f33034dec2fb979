#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "app/commands/commands.hpp"
#include "app/memory/memory_json.hpp"
#include "app/memory/open_memory.hpp"
#include "app/memory/picture_view.hpp"
#include "app/read_picture.hpp"
#include "app/robot_settings.hpp"
#include "config/user_error.hpp"
#include "memory/long_term/memory_writer.hpp"
#include "memory/long_term/teaching.hpp"

namespace striate {
namespace {

struct TeachOptions {
  std::string name;
  std::vector<std::string> images;
  std::string memory = "home.db";
  std::string robot;  ///< settings file; empty: the defaults
  bool undo = false;
  bool json = false;
};

/// Files as they are; of a folder all pictures, by name.
std::vector<std::string> picture_files(const std::vector<std::string>& given) {
  static const std::vector<std::string> kEndings = {".png", ".jpg", ".jpeg", ".bmp",
                                                    ".ppm", ".pgm", ".tif",  ".tiff"};
  std::vector<std::string> files;
  for (const std::string& one : given) {
    if (!std::filesystem::is_directory(one)) {
      files.push_back(one);
      continue;
    }
    std::vector<std::string> inside;
    for (const auto& entry : std::filesystem::directory_iterator(one)) {
      std::string ending = entry.path().extension();
      std::transform(ending.begin(), ending.end(), ending.begin(),
                     [](unsigned char letter) { return std::tolower(letter); });
      if (std::find(kEndings.begin(), kEndings.end(), ending) != kEndings.end()) {
        inside.push_back(entry.path());
      }
    }
    if (inside.empty()) {
      throw UserError(fmt::format("{}: no picture in it (png, jpg, bmp, ppm, pgm, tif)", one));
    }
    std::sort(inside.begin(), inside.end());
    files.insert(files.end(), inside.begin(), inside.end());
  }
  return files;
}

void print_taught(const TeachOptions& options, const Taught& taught) {
  if (options.json) {
    fmt::print("{}", print_json({{"name", options.name},
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

void teach_pictures(const TeachOptions& options) {
  check_landmark_name(options.name);
  const LongTermSettings settings = load_robot_settings(options.robot).long_term_memory;
  std::vector<StoredView> views;
  for (const std::string& file : picture_files(options.images)) {
    views.push_back(view_of_picture(read_any_picture(file), settings));
  }
  const MemoryOptions opening = memory_options(Access::session, "striate teach");
  MemoryWriter writer(options.memory, opening);
  print_notices(writer.notices());
  Taught taught;
  writer.commit([&](MemoryTables& tables) {
    const Session session = tables.sessions.begin(SessionKind::teach, software_name(), options.name,
                                                  opening.now_unix_s);
    taught = teach(tables, session, options.name, views, settings);
    tables.sessions.end(session.id, 0.0, "kept");
  });
  print_taught(options, taught);
}

void undo(const TeachOptions& options) {
  MemoryFile(options.memory, memory_options(Access::read, "striate teach"));  // must be there
  MemoryWriter writer(options.memory, memory_options(Access::session, "striate teach"));
  print_notices(writer.notices());
  std::string done;
  writer.commit([&](MemoryTables& tables) { done = undo_teaching(tables); });
  if (options.json) {
    fmt::print("{}", print_json({{"done", done}}));
  } else {
    fmt::print("{}: {}\n", options.memory, done);
  }
}

int run(const TeachOptions& options) {
  if (options.undo) {
    if (!options.name.empty() || !options.images.empty()) {
      throw UserError(
          "--undo takes back what was taught last, whatever it is: give no name and no picture\n"
          "    striate teach --undo --memory home.db");
    }
    undo(options);
    return 0;
  }
  if (options.name.empty() || options.images.empty()) {
    throw UserError(
        "what is to be learned, and from which picture?\n"
        "    striate teach NAME --image PICTURE --memory home.db");
  }
  teach_pictures(options);
  return 0;
}

}  // namespace

void add_teach_command(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<TeachOptions>();
  CLI::App* command = app.add_subcommand(
      "teach",
      "Teaches a landmark by its name from pictures of it; it is on the disk when this ends.\n"
      "Example: striate teach book --image cover.png --image back.png --memory home.db\n"
      "Says so where the thing looks like a known one, or has too little structure.");
  command->add_option("name", options->name, "the name it gets; a known one gets further views");
  command
      ->add_option("--image", options->images,
                   "a picture that shows the thing and little else, or a folder of such; "
                   "several: several sides")
      ->allow_extra_args(false);
  command->add_option("--memory", options->memory, "the memory; made where there is none")
      ->capture_default_str();
  command->add_option("--robot", options->robot, "settings of the robot and its mind");
  command->add_flag(
      "--undo", options->undo,
      "takes back the views that were taught last; older ones that made room for them "
      "do not come back");
  command->add_flag("--json", options->json, "print JSON instead of text");
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace striate
