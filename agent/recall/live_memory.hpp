#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <thread>

#include "striate/agent/cognitive_cycle.hpp"

namespace striate::agent {

/// Keeps a file up to date with what short-term memory holds, once a second, for `striate recall`.
/// A thread of its own writes; the cycle leaves the newest state in a mailbox and goes on. The file
/// is always whole: it is written beside and renamed.
class LiveMemory {
 public:
  /// @param file "" for none. @throws UserError where nothing can be written there.
  explicit LiveMemory(std::string file);
  ~LiveMemory();
  LiveMemory(const LiveMemory&) = delete;
  LiveMemory& operator=(const LiveMemory&) = delete;

  /// Called each cycle.
  void take(const CognitiveCycle& cycle, const tasks::Executive& executive, std::uint64_t number);
  /// Writes what waits. @return what could not be written and why; "" for nothing
  std::string finish();

 private:
  void work();
  [[nodiscard]] std::string keep(const nlohmann::ordered_json& state) const;

  std::string file_;
  std::chrono::steady_clock::time_point taken_;
  std::mutex mutex_;
  std::condition_variable wake_;
  std::optional<nlohmann::ordered_json> mailbox_;
  bool ending_ = false;
  std::string why_lost_;
  std::thread thread_;
};

}  // namespace striate::agent
