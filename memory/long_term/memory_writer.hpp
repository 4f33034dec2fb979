#pragma once

#include <condition_variable>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "striate/memory/long_term/memory_file.hpp"
#include "striate/memory/long_term/memory_tables.hpp"

namespace striate::memory {

/// The one thread that commits. The cycle posts what is to be kept and goes on; what a person
/// taught is waited for until it is on the disk.
class MemoryWriter {
 public:
  /// Runs in the writer's thread, within a transaction.
  using Job = std::function<void(MemoryTables&)>;

  /// Opens or makes the memory. @throws UserError as MemoryFile.
  MemoryWriter(const std::string& path, const MemoryOptions& options);
  /// Commits what is queued, then closes.
  ~MemoryWriter();
  MemoryWriter(const MemoryWriter&) = delete;
  MemoryWriter& operator=(const MemoryWriter&) = delete;

  /// Queues and returns at once; committed with synchronous NORMAL. When the queue is full the job
  /// is dropped and counted: memory must not stall the robot.
  void post(Job job);
  /// Commits with synchronous FULL, after all that was posted before, and returns when it is on the
  /// disk. @throws UserError with a sentence where it could not be; then nothing of it was kept.
  void commit(const Job& job);

  /// Posted jobs that were lost: queue full, disk full.
  [[nodiscard]] std::uint64_t lost() const;
  /// Why the last ones were lost, in a sentence; empty: none was.
  [[nodiscard]] std::string why_lost() const;
  [[nodiscard]] const std::vector<std::string>& notices() const { return file_.notices(); }

 private:
  static constexpr std::size_t kMostQueued = 1024;  ///< by hand: jobs, 100 s at one in each cycle

  void work();
  void commit_posted(std::vector<Job>& jobs);
  void note_loss(std::size_t jobs, const char* why) noexcept;
  void commit_taught(const Job& job);
  void set_synchronous(bool full);

  MemoryFile file_;
  MemoryTables tables_;
  bool full_ = false;

  mutable std::mutex mutex_;
  std::condition_variable wake_;  ///< the writer: there is something
  std::condition_variable done_;  ///< who waits: the taught job has ended
  std::vector<Job> posted_;
  const Job* taught_ = nullptr;
  std::exception_ptr taught_error_;
  bool ending_ = false;
  std::uint64_t lost_ = 0;
  std::string why_lost_;
  std::mutex one_teacher_;
  std::thread thread_;  ///< last: it uses all of the above
};

}  // namespace striate::memory
