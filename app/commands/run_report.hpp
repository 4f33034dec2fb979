#pragma once

#include <string>
#include <vector>

#include "striate/agent/mission.hpp"

/// What `striate run` tells a person, while it runs and in the end, whatever the body.
namespace striate::app {

/// A part of the live line. Where the terminal is narrow, the part with the highest number is left
/// out first; 0: never.
struct StatusPart {
  int drops = 0;
  std::string text;
};
/// All parts that fit into so many columns, in their order.
[[nodiscard]] std::string fitting(const std::vector<StatusPart>& parts, std::size_t columns);

/// The live line: time, way, speed, what it costs, what holds the robot and what it does.
/// @param columns of the terminal; what the robot does is the last to be left out
[[nodiscard]] std::string status_text(const agent::Mission& mission, std::size_t columns);

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
