#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "striate/viewer/dashboard/run_store.hpp"
#include "striate/viewer/dashboard/site.hpp"

namespace striate::viewer::dashboard {

/// A recording of Striate's own, or an MCAP file with its channels, read by a thread of its own so
/// that what was read so far can be looked at.
class ShownRun {
 public:
  /// @throws UserError where the file cannot be read or is neither
  explicit ShownRun(const std::string& file);
  ~ShownRun();
  ShownRun(const ShownRun&) = delete;
  ShownRun& operator=(const ShownRun&) = delete;

  [[nodiscard]] const RunStore& store() const { return store_; }
  /// What the page shows of it as a whole: name, cycles so far, whether there is more to come.
  [[nodiscard]] nlohmann::ordered_json about() const;

 private:
  class Source;
  class Recorded;
  class McapSource;
  void work();

  std::string name_;
  RunStore store_;
  std::unique_ptr<Source> source_;
  std::atomic<bool> ending_{false};
  mutable std::mutex mutex_;  ///< guards what follows
  nlohmann::ordered_json facts_;
  bool done_ = false;
  std::string error_;
  std::thread thread_;
};

using ShownRuns = std::vector<std::shared_ptr<ShownRun>>;

/// GET /api/recording, and of its cycles /api/recording/cycle, /span, /channels, /difference. A
/// second run is compared with the first.
void add_recording_pages(Site& site, const ShownRuns& runs);

}  // namespace striate::viewer::dashboard
