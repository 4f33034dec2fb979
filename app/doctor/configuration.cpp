#include "striate/app/doctor/configuration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "striate/agent/open_memory.hpp"
#include "striate/agent/robot_settings.hpp"
#include "striate/base/shell_text.hpp"
#include "striate/base/user_error.hpp"
#include "striate/memory/long_term/damage.hpp"
#include "striate/platform/simulator/world_reader.hpp"
#include "striate/tasks/task_reader.hpp"

namespace striate::app {
namespace {

namespace fs = std::filesystem;
using Grade = Finding::Grade;

struct FolderKind {
  const char* folder;
  std::function<void(const std::string&)> read;
};

std::vector<fs::path> yaml_files(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    if (entry.path().extension() == ".yaml") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

void look_at_folder(const fs::path& folder, const FolderKind& kind, Findings& findings) {
  const auto files = yaml_files(folder / kind.folder);
  int good = 0;
  for (const fs::path& file : files) {
    try {
      kind.read(file);
      ++good;
    } catch (const UserError& error) {
      findings.push_back(
          {Grade::wrong, file, error.what(), "correct it: striate check tells more"});
    }
  }
  const std::string about = (folder / kind.folder).string();
  if (files.empty()) {
    findings.push_back({Grade::note, about, "no YAML files are there",
                        "'striate config --paths' says where others are; or say --config FOLDER"});
  } else if (good > 0) {
    findings.push_back({Grade::good, about, fmt::format("{} files are good", good), {}});
  }
}

std::vector<FolderKind> kinds() {
  return {
      {"worlds", [](const std::string& file) { (void)simulator::load_world(file); }},
      {"tasks", [](const std::string& file) { (void)tasks::check_task(file, RobotDescription{}); }},
      {"robots", [](const std::string& file) { (void)agent::load_robot_settings(file); }},
  };
}

}  // namespace

Findings look_at_configuration(const fs::path& folder) {
  Findings findings;
  for (const FolderKind& kind : kinds()) look_at_folder(folder, kind, findings);
  return findings;
}

Findings look_at_configurations(const std::vector<config::ConfigurationFolder>& folders) {
  Findings findings;
  for (const config::ConfigurationFolder& folder : folders) {
    for (const FolderKind& kind : kinds()) {
      std::error_code none;
      if (fs::is_directory(folder.path / kind.folder, none)) {
        look_at_folder(folder.path, kind, findings);
      }
    }
  }
  if (findings.empty()) {
    findings.push_back({Grade::note, "tasks, worlds and robots", "no folder with them is there",
                        "'striate config --paths' says where they are looked for"});
  }
  return findings;
}

Finding look_at_memory(const std::string& file) {
  if (!fs::exists(file)) {
    return {Grade::note, file, "no memory is there yet", "striate run --memory makes it"};
  }
  try {
    std::vector<std::string> damage;
    std::int64_t landmarks = 0;
    agent::with_memory(
        file, memory::Access::read, "checking it",
        [&](memory::MemoryTables&, memory::MemoryFile& opened) {
          damage = memory::find_damage(opened.database());
          landmarks = opened.database().execAndGet("SELECT count(*) FROM landmark").getInt64();
        });
    if (damage.empty()) return {Grade::good, file, fmt::format("{} landmarks", landmarks), {}};
    return {Grade::wrong, file, damage.front(),
            damage.size() > 1 ? fmt::format("{} more: striate memory {} check", damage.size() - 1,
                                            shell_word(file))
                              : ""};
  } catch (const UserError& error) {
    return {Grade::wrong, file, error.what(), "give another file, or a backup"};
  }
}

}  // namespace striate::app
