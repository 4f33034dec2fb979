#pragma once

#include <string>

#include "app/mission.hpp"

/// What `striate run` tells a person, while it runs and in the end, whatever the body.
namespace striate {

/// The live line: time, way, speed, what it costs, what the robot does and what holds it.
[[nodiscard]] std::string status_text(const Mission& mission);

/// What the task says, once each: it is shown as a line that stays.
class Speech {
 public:
  /// After each cycle. @return what is said since this cycle; "" for nothing new
  [[nodiscard]] std::string news(const Mission& mission);

 private:
  std::string said_;
};

/// On standard output; without what only a judge knows where there was none.
void print_summary(const RunResult& result);

}  // namespace striate
