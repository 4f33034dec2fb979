#pragma once

#include <memory>
#include <string>

#include "app/mission.hpp"
#include "app/recording/recorder.hpp"

namespace striate {

/// The recording of a simulated mission; watches from outside, as MissionPictures does.
class MissionRecorder {
 public:
  /// @param file "" for none. @throws UserError where it cannot be written; nothing has moved yet.
  MissionRecorder(std::string file, const Mission& mission);

  /// Called each cycle, before anything ends the task from outside.
  void take(const Mission& mission);
  /// Closes the file. What was lost is said on standard error.
  /// @return for the summary: what was kept, in how many bytes; "" without a file
  std::string finish();

 private:
  std::string file_;
  std::unique_ptr<Recorder> recorder_;
};

}  // namespace striate
