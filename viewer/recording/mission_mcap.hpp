#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "striate/agent/mission.hpp"
#include "striate/agent/recording/mission_recorder.hpp"
#include "striate/viewer/channels/facts_ring.hpp"
#include "striate/viewer/recording/facts_file.hpp"

namespace striate::viewer {

/// A mission as an MCAP file, written by a thread of its own while it runs. The cycle leaves a copy
/// of its facts and never waits: where the disk is too slow whole cycles are left out, where it is
/// full the file ends and the mission goes on.
class MissionMcap {
 public:
  /// Cycles that wait for the thread, by hand: 3.2 s, in 80 MB for images of 640 x 480
  static constexpr std::size_t kSlots = 32;

  /// @param file "" for none. @param memory the long-term memory, "" for none: it is copied as it
  /// is now, so before a session begins. @throws UserError where it cannot be had
  MissionMcap(std::string file, mcap::Compression compression, const std::string& memory);
  ~MissionMcap();
  MissionMcap(const MissionMcap&) = delete;
  MissionMcap& operator=(const MissionMcap&) = delete;

  /// Before the first cycle. @throws UserError where nothing can be written; nothing has moved yet.
  void begin(const agent::Mission& mission);
  /// Called each cycle, before anything ends the task from outside.
  void take(const agent::Mission& mission);
  /// Writes what waits and closes the file. Says nothing itself.
  agent::RecordingEnd finish();

 private:
  void work();
  void keep(const CycleFacts& facts) noexcept;
  void note_failure(const char* why) noexcept;
  [[nodiscard]] agent::RecordingEnd end() const;

  std::string file_;
  mcap::Compression compression_;
  std::vector<std::uint8_t> memory_;
  std::unique_ptr<FactsFile> writer_;

  // The cycle's side.
  FactsTaker taker_;

  FactsRing ring_{kSlots};

  // The thread's side.
  bool failed_ = false;
  std::string why_failed_;
  std::thread thread_;
};

}  // namespace striate::viewer
