#include "striate/agent/recording/mission_recorder.hpp"

#include <fmt/format.h>

#include <utility>

#include "striate/agent/recording/setup.hpp"
#include "striate/agent/simulated_body.hpp"

namespace striate::agent {

replay::RecordedSetup setup_of(const Mission& mission) {
  replay::RecordedSetup setup =
      record_setup(mission.executive().task(), mission.given(), mission.robot_file(),
                   mission.settings(), mission.body().description());
  if (mission.simulated() == nullptr) return setup;
  setup.world = mission.place();
  setup.seed = mission.simulated()->options().seed;
  return setup;
}

MissionRecorder::MissionRecorder(std::string file, const std::string& memory)
    : file_(std::move(file)) {
  if (file_.empty() || memory.empty()) return;
  memory_known_ = true;
  memory_ = copy_of_memory(memory);
}

void MissionRecorder::begin(const Mission& mission) {
  if (file_.empty()) return;
  replay::RecordedSetup setup = setup_of(mission);
  setup.memory_known = memory_known_;
  setup.memory = std::move(memory_);
  recorder_ = std::make_unique<Recorder>(file_, setup);
}

void MissionRecorder::take(const Mission& mission) {
  if (recorder_) recorder_->take(mission.cycle().trace(), mission.executive());
}

RecordingEnd MissionRecorder::finish() {
  if (!recorder_) return {};
  RecordingEnd end;
  const RecorderReport report = recorder_->finish();
  if (report.lost > 0) {
    end.lost = fmt::format("{}: {} of {} cycles were not recorded: {}", file_, report.lost,
                           report.kept + report.lost, report.why_lost);
  } else if (report.failed) {
    end.lost = fmt::format("{}: its end is missing: {}", file_, report.why_lost);
  }
  end.failed = report.failed;
  end.kept = fmt::format("{}, {} cycles, {:.1f} MB", file_, report.kept,
                         static_cast<double>(report.bytes) / 1e6);
  return end;
}

}  // namespace striate::agent
