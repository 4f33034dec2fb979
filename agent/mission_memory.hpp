#pragma once

#include <memory>
#include <string>

#include "striate/agent/mission.hpp"
#include "striate/agent/run_result.hpp"
#include "striate/memory/long_term/episode_gate.hpp"
#include "striate/memory/long_term/memory_writer.hpp"
#include "striate/platform/simulator/judge.hpp"

namespace striate::agent {

/// What a mission leaves in the long-term memory: a session, and the episodes of it. Watches from
/// outside: nothing of it reaches the driving, and the writer's thread alone touches the disk.
class MissionMemory {
 public:
  /// @param file "" for none. @param task its file, for the name of the session. @throws UserError
  /// where the memory cannot be opened; nothing has moved.
  MissionMemory(const std::string& file, const Mission& mission, const std::string& task);

  /// Called after each cycle.
  void take(Mission& mission);
  /// Closes the session. @return what could not be kept, a line each; "" for nothing
  std::string finish(Mission& mission, const RunResult& result);

 private:
  void take(CognitiveCycle& cycle);
  /// In a simulated world: what only a judge beside the robot knows.
  void take(const simulator::Judge& judge);
  /// What is new about places goes to the writer, now and then.
  void take_map(CognitiveCycle& cycle);
  /// What looks have taught: landmarks grow stronger or weaker.
  void keep_lessons(const CycleTrace& trace);
  /// Keeps an episode if it is news. @param about what it is about: the same again is none.
  void note(const std::string& kind, const std::string& about, const std::string& text);
  [[nodiscard]] memory::Episode episode_now(const std::string& kind, const std::string& text) const;

  std::unique_ptr<memory::MemoryWriter> writer_;
  memory::Session session_;
  memory::LongTermSettings settings_;
  memory::EpisodeGate gate_;
  TimePoint now_{};  ///< of the newest cycle, and where the robot was
  Pose2 pose_;
  double noted_s_ = 0.0;
  double map_kept_s_ = 0.0;
  std::size_t collisions_ = 0;
  std::size_t near_misses_ = 0;
  int emergency_stops_ = 0;
};

}  // namespace striate::agent
