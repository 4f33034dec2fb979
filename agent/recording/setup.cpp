#include "striate/agent/recording/setup.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "striate/agent/open_memory.hpp"
#include "striate/agent/plugins/load_plugin.hpp"
#include "striate/base/files.hpp"
#include "striate/base/shell_text.hpp"
#include "striate/base/user_error.hpp"

namespace striate::agent {
namespace {

namespace fs = std::filesystem;

/// 128 MiB: half of a chunk (recording_format.hpp); a larger memory is not copied
constexpr std::uintmax_t kMostMemory_bytes = 128U << 20U;

/// The innermost folder that all files are in.
fs::path common_folder(const std::vector<tasks::TaskFile>& files) {
  if (files.empty()) return {};
  fs::path common = fs::path(files.front().place).parent_path();
  for (const tasks::TaskFile& file : files) {
    while (!common.empty() &&
           fs::path(file.place).lexically_relative(common).string().starts_with("..")) {
      common = common.parent_path();
    }
  }
  return common;
}

}  // namespace

std::vector<replay::NamedText> printed_settings(RobotSettings settings) {
  config::SettingsPrinter printer;
  visit(printer, settings);
  std::vector<replay::NamedText> list;
  for (const config::SettingLine& line : printer.lines()) list.emplace_back(line.key, line.value);
  return list;
}

replay::RecordedSetup record_setup(const tasks::Task& task, const tasks::GivenVariables& given,
                                   const std::string& robot_file, const RobotSettings& settings,
                                   const RobotDescription& robot) {
  replay::RecordedSetup setup;
  setup.software = software_name();
  setup.task = task.file;
  const fs::path folder = common_folder(task.files);
  for (const tasks::TaskFile& file : task.files) {
    setup.task_files.emplace_back(fs::path(file.place).lexically_relative(folder).string(),
                                  read_file(file.path));
  }
  setup.variables.assign(given.begin(), given.end());
  setup.robot_file = robot_file;
  if (!robot_file.empty()) setup.robot_text = read_file(robot_file);
  setup.settings = printed_settings(settings);
  for (const PluginInUse& plugin : plugins_in_use()) {
    setup.settings.emplace_back(kRecordedPlugin + plugin.name, plugin.file);
  }
  setup.emergency_layer = settings.safety.emergency_layer;
  setup.robot = robot;
  return setup;
}

std::vector<std::uint8_t> copy_of_memory(const std::string& memory) {
  if (!fs::exists(memory)) return {};
  if (fs::file_size(memory) > kMostMemory_bytes) {
    throw UserError(fmt::format(
        "{}: is too large to go into a recording or an MCAP file, which take 128 MB at most\n"
        "  hint: run without --record and --mcap, or: striate memory {} prune",
        memory, shell_word(memory)));
  }
  const ScratchFolder scratch;
  const std::string copy = scratch / "memory.db";
  memory::MemoryFile(memory, memory_options(memory::Access::read, "striate run")).copy_to(copy);
  const std::string bytes = read_file(copy);
  return {bytes.begin(), bytes.end()};
}

RecordedFiles::RecordedFiles(const replay::RecordedSetup& setup) {
  if (!setup.memory.empty()) {
    memory_ = folder_ / "memory.db";
    write_file(memory_, std::string(setup.memory.begin(), setup.memory.end()));
  }
  for (const auto& [name, text] : setup.task_files) {
    const fs::path relative = fs::path(name).lexically_normal();
    if (relative.empty() || relative.is_absolute() || relative.string().starts_with("..")) {
      throw UserError(fmt::format("the recording names a task file '{}', which is no place", name));
    }
    const std::string file = (fs::path(folder_.path()) / "task" / relative).string();
    check_writable(file);
    write_file(file, text);
    if (task_.empty()) task_ = file;
  }
  if (setup.robot_file.empty()) return;
  robot_ = folder_ / "robot.yaml";
  write_file(robot_, setup.robot_text);
}

}  // namespace striate::agent
