#pragma once

#include <optional>
#include <string>
#include <vector>

#include "striate/agent/robot_settings.hpp"
#include "striate/base/files.hpp"
#include "striate/platform/replay/recording.hpp"
#include "striate/tasks/task.hpp"
#include "striate/tasks/task_reader.hpp"

namespace striate::agent {

/// All settings in force, as `striate config` prints them.
[[nodiscard]] std::vector<replay::NamedText> printed_settings(RobotSettings settings);

/// How the settings of a recording call the plugins of the run: "plugins.NAME", with the file.
inline constexpr const char* kRecordedPlugin = "plugins.";

/// The settings' file, all in force and the plugins in use, the task with the files that it uses,
/// what it was given, and the body. World, seed and memory are left to the caller.
/// @throws UserError where a file cannot be read any more
[[nodiscard]] replay::RecordedSetup record_setup(const tasks::Task& task,
                                                 const tasks::GivenVariables& given,
                                                 const std::string& robot_file,
                                                 const RobotSettings& settings,
                                                 const RobotDescription& robot);

/// A long-term memory as a file's bytes, as it is now; none where it is still to be made.
/// @throws UserError as MemoryFile does, and where it is too large for a recording
[[nodiscard]] std::vector<std::uint8_t> copy_of_memory(const std::string& memory);

/// The files of a recording, laid out in a folder that is gone in the end, so that they are read
/// as any others are.
class RecordedFiles {
 public:
  /// @throws UserError for a recording with file names that lead out of the folder
  explicit RecordedFiles(const replay::RecordedSetup& setup);

  [[nodiscard]] const std::string& task() const { return task_; }
  [[nodiscard]] const std::string& robot() const { return robot_; }    ///< "": built-in settings
  [[nodiscard]] const std::string& memory() const { return memory_; }  ///< "": it was to be made

 private:
  ScratchFolder folder_;
  std::string task_;
  std::string robot_;
  std::string memory_;
};

}  // namespace striate::agent
