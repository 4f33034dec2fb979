#include "striate/agent/recording/recorder.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include "striate/platform/replay/recording_reader.hpp"
#include "striate/tasks/task_reader.hpp"
#include "tests/reference/recorded_cycles.hpp"
#include "tests/reference/temporary_folder.hpp"

namespace striate::agent {
namespace {

/// Files end at so many bytes, as on a full disk.
class DiskOf {
 public:
  explicit DiskOf(rlim_t bytes) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~DiskOf() { setrlimit(RLIMIT_FSIZE, &before_); }

 private:
  rlimit before_{};
};

TEST(Recorder, OnAFullDiskKeepsWhatWasWholeAndCountsTheRest) {
  constexpr std::uint64_t kCycles = 40;
  const reference::TemporaryFolder folder;
  const std::string file = folder / "run.rec";
  const tasks::Executive executive(
      tasks::load_task(STRIATE_SOURCE_DIR "/config/tasks/look.yaml", {}));
  RecorderReport report;
  {
    const DiskOf disk(40'000);
    Recorder recorder(file, reference::a_setup());
    for (std::uint64_t number = 1; number <= kCycles; ++number) {
      CycleTrace trace;
      trace.senses = reference::a_cycle(number).senses;
      recorder.take(trace, executive);
    }
    report = recorder.finish();
  }
  EXPECT_GT(report.kept, 0U);
  EXPECT_GT(report.lost, 0U);
  EXPECT_EQ(report.kept + report.lost, kCycles);
  EXPECT_FALSE(report.why_lost.empty());
  replay::RecordingReader reader(file);
  replay::RecordedCycle cycle;
  std::uint64_t read = 0;
  while (reader.next(cycle)) ++read;
  EXPECT_EQ(read, report.kept);
  EXPECT_EQ(reader.ending(), replay::Ending::cut_off);
}

}  // namespace
}  // namespace striate::agent
