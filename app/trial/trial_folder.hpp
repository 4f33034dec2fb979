#pragma once

#include <string>

namespace striate::app {

/// Where a trial writes: one trial at a time, as long as this lives. The lock is on the folder
/// itself, so nothing of it stays when the trial is killed.
class TrialFolder {
 public:
  /// Makes the folder and its `runs`. @throws UserError where another trial writes into it
  explicit TrialFolder(const std::string& out);
  ~TrialFolder();
  TrialFolder(const TrialFolder&) = delete;
  TrialFolder& operator=(const TrialFolder&) = delete;

 private:
  int descriptor_ = -1;
};

}  // namespace striate::app
