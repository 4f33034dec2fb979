#pragma once

#include <string>

#include "striate/agent/mission.hpp"

/// What `striate run` tells a person, while it runs and in the end, whatever the body.
namespace striate::app {

/// The live line: time, way, speed, what it costs, what the robot does and what holds it.
[[nodiscard]] std::string status_text(const agent::Mission& mission);

/// What the task says, once each: it is shown as a line that stays.
class Speech {
 public:
  /// After each cycle. @return what is said since this cycle; "" for nothing new
  [[nodiscard]] std::string news(const agent::Mission& mission);

 private:
  std::string said_;
};

/// For standard output; without what only a judge knows where there was none.
[[nodiscard]] std::string summary_text(const agent::RunResult& result);

}  // namespace striate::app
