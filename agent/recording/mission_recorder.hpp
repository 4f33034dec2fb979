#pragma once

#include <memory>
#include <string>

#include "striate/agent/mission.hpp"
#include "striate/agent/recording/recorder.hpp"

namespace striate::agent {

/// What a run is begun with. The memory is left to the caller.
/// @throws UserError where a file cannot be read any more
[[nodiscard]] replay::RecordedSetup setup_of(const Mission& mission);

/// What a person is told of a recording.
struct RecordingEnd {
  std::string kept;     ///< in how many bytes; "" without a file
  std::string lost;     ///< how much and why; "" for nothing
  bool failed = false;  ///< the file could not be written on
};

/// The recording of a mission; watches from outside, as MissionImages does.
class MissionRecorder {
 public:
  /// @param file "" for none. @param memory the long-term memory, "" for none: it is copied as it
  /// is now, so before a session begins. @throws UserError where it cannot be had
  MissionRecorder(std::string file, const std::string& memory);

  /// Before the first cycle. @throws UserError where nothing can be written; nothing has moved yet.
  void begin(const Mission& mission);
  /// Called each cycle, before anything ends the task from outside.
  void take(const Mission& mission);
  /// Closes the file.
  RecordingEnd finish();

 private:
  std::string file_;
  bool memory_known_ = false;
  std::vector<std::uint8_t> memory_;
  std::unique_ptr<Recorder> recorder_;
};

}  // namespace striate::agent
