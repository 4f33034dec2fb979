#pragma once

#include <array>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "striate/agent/cognitive_cycle.hpp"
#include "striate/platform/replay/recording.hpp"

namespace striate::agent {

/// What became of a recording.
struct RecorderReport {
  std::uint64_t kept = 0;   ///< whole cycles in the file
  std::uint64_t lost = 0;   ///< cycles that are not
  std::uint64_t bytes = 0;  ///< size of the file
  std::string why_lost;     ///< in words; empty: nothing was lost
  bool failed = false;      ///< the file could not be written on: it is cut off
};

/// Writes each cycle of a run into a file, in a thread of its own. The cycle hands over a copy and
/// never waits: where the disk is too slow whole cycles are left out, where it is full the
/// recording ends and the mission goes on. What is in the file is whole at any moment.
class Recorder {
 public:
  static constexpr std::size_t kSlots = 64;  ///< cycles that wait for the disk: six seconds

  /// Writes the head of the file. @throws UserError where it cannot be written.
  Recorder(const std::string& file, const replay::RecordedSetup& setup);
  ~Recorder();
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  /// Called each cycle.
  void take(const CycleTrace& trace, const tasks::Executive& executive);
  /// Writes what waits and closes the file. Says nothing itself.
  RecorderReport finish();

 private:
  struct Slot {
    replay::RecordedCycle cycle;
    bool same_images = false;
  };
  void fill(Slot& slot, const CycleTrace& trace, const tasks::Executive& executive);
  void work();
  void keep(const Slot& slot);
  bool write_cycle(const Slot& slot);
  void note_failure(const char* why) noexcept;
  bool write(const std::vector<std::uint8_t>& bytes);
  void close_file();

  std::string file_;
  int descriptor_ = -1;

  // The cycle's side.
  std::uint64_t number_ = 0;
  bool images_queued_ = false;
  TimePoint images_stamp_;

  // Shared: which slots are filled.
  std::mutex mutex_;
  std::condition_variable wake_;
  std::uint64_t filled_ = 0;
  std::uint64_t emptied_ = 0;
  bool ending_ = false;
  RecorderReport report_;
  std::array<Slot, kSlots> slots_;

  // The thread's side.
  std::vector<std::uint8_t> payload_;
  std::vector<std::uint8_t> chunk_;
  std::uint64_t whole_bytes_ = 0;
  bool failed_ = false;
  std::thread thread_;
};

}  // namespace striate::agent
