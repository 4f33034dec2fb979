#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>

namespace striate::python {

/// The missions of all threads. An interpreter that ends gives its lock to no thread any more, and
/// unwinds those that ask for it: a robot would drive on with its last command. So they are ended
/// before, by whoever ends the interpreter.
class RunningMissions {
 public:
  /// @throws std::runtime_error where the interpreter is about to end; the mission stops the wheels
  void check() const;
  /// Tells them all and waits until none runs. Without the interpreter's lock.
  /// @param patience at most @return whether none runs
  bool end(std::chrono::milliseconds patience);

 private:
  friend class RunningMission;
  mutable std::mutex mutex_;
  std::condition_variable over_;
  int running_ = 0;
  bool ending_ = false;
};

/// Those of this process.
[[nodiscard]] RunningMissions& running_missions();

/// One of them, as long as it lives.
class RunningMission {
 public:
  RunningMission();
  ~RunningMission();
  RunningMission(const RunningMission&) = delete;
  RunningMission& operator=(const RunningMission&) = delete;
};

}  // namespace striate::python
