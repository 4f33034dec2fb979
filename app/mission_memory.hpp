#pragma once

#include <memory>
#include <string>

#include "app/mission.hpp"
#include "memory/long_term/episode_gate.hpp"
#include "memory/long_term/memory_writer.hpp"

namespace striate {

/// What a mission leaves in the long-term memory: a session, and the episodes of it. Watches from
/// outside: nothing of it reaches the driving, and the writer's thread alone touches the disk.
class MissionMemory {
 public:
  /// @param file "" for none. @throws UserError where it cannot be opened; nothing has moved yet.
  MissionMemory(const std::string& file, const MissionOptions& mission);

  /// Called each cycle.
  void take(Mission& mission);
  /// Closes the session. What could not be kept is said on standard error: the mission is over.
  void finish(Mission& mission, const RunResult& result);

 private:
  /// What is new about places goes to the writer, now and then.
  void take_places(Mission& mission);
  /// What looks have taught: landmarks grow stronger or weaker.
  void keep_lessons(const Mission& mission);
  /// Keeps an episode if it is news. @param about what it is about: the same again is none.
  void note(const Mission& mission, const std::string& kind, const std::string& about,
            const std::string& text);
  [[nodiscard]] Episode episode_now(const Mission& mission, const std::string& kind,
                                    const std::string& text) const;

  std::unique_ptr<MemoryWriter> writer_;
  Session session_;
  LongTermSettings settings_;
  EpisodeGate gate_;
  double noted_s_ = 0.0;
  double places_kept_s_ = 0.0;
  std::size_t collisions_ = 0;
  std::size_t near_misses_ = 0;
  int emergency_stops_ = 0;
};

}  // namespace striate
