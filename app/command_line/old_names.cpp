#include "striate/app/command_line/old_names.hpp"

#include <fmt/format.h>

#include "striate/app/command_line/command_walk.hpp"

namespace striate::app {
namespace {

struct OldName {
  const char* command;
  const char* old_name;
  const char* new_name;
};

/// To be emptied with version 0.3.
constexpr OldName kOldNames[] = {
    {"striate sim", "--tilt", "--tilt-deg"},
    {"striate sim", "--pan", "--pan-deg"},
    {"striate sim", "--width", "--width-px"},
    {"striate sim", "--delay", "--delay-s"},
    {"striate sim", "--silent-at", "--silent-at-s"},
    {"striate sim", "--silent-for", "--silent-for-s"},
    {"striate sim", "--laser-silent-at", "--laser-silent-at-s"},
    {"striate sim", "--turret-sticks-at", "--turret-sticks-at-s"},
    {"striate sim", "--break-at", "--break-at-s"},
    {"striate drive", "--forward", "--forward-m-s"},
    {"striate drive", "--turn", "--turn-deg-s"},
    {"striate drive", "--for", "--for-s"},
    {"striate drive", "--way", "--way-m"},
    {"striate perceive", "--setting", "--mode"},
    {"striate perceive", "--width", "--width-px"},
    {"striate calibrate", "--square", "--square-mm"},
    {"striate learn-descriptor", "--pictures", "--picture-count"},
};

const OldName* old_name(const StrangeWord& strange) {
  if (strange.kind != StrangeWord::Kind::option) return nullptr;
  const std::string command = path_of(*strange.where);
  for (const OldName& one : kOldNames) {
    if (command == one.command && strange.word == one.old_name) return &one;
  }
  return nullptr;
}

}  // namespace

std::vector<std::string> use_new_names(const CLI::App& app, std::vector<std::string>& words) {
  std::vector<std::string> notes;
  // Only with its new name it is known how many words an option takes: so one after the other.
  bool replaced = true;
  while (replaced) {
    replaced = false;
    for (const StrangeWord& strange : walk_command_line(app, words).strange) {
      const OldName* found = old_name(strange);
      if (found == nullptr) continue;
      words[strange.index].replace(0, strange.word.size(), found->new_name);
      notes.push_back(
          fmt::format("{}: {} is now called {}; the old name goes with the next version",
                      found->command, found->old_name, found->new_name));
      replaced = true;
      break;
    }
  }
  return notes;
}

}  // namespace striate::app
