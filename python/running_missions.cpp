#include "striate/python/running_missions.hpp"

#include <stdexcept>

namespace striate::python {

void RunningMissions::check() const {
  const std::lock_guard lock(mutex_);
  if (ending_) throw std::runtime_error("the Python interpreter ends");
}

bool RunningMissions::end(std::chrono::milliseconds patience) {
  std::unique_lock lock(mutex_);
  ending_ = true;
  return over_.wait_for(lock, patience, [this] { return running_ == 0; });
}

RunningMissions& running_missions() {
  static auto* all = new RunningMissions();  // never destroyed: threads may outlive main()
  return *all;
}

RunningMission::RunningMission() {
  RunningMissions& all = running_missions();
  const std::lock_guard lock(all.mutex_);
  ++all.running_;
}

RunningMission::~RunningMission() {
  RunningMissions& all = running_missions();
  {
    const std::lock_guard lock(all.mutex_);
    --all.running_;
  }
  all.over_.notify_all();
}

}  // namespace striate::python
