#include "app/recording/mission_recorder.hpp"

#include <fmt/format.h>

#include <utility>

#include "app/recording/setup.hpp"

namespace striate {

replay::RecordedSetup setup_of(const Mission& mission) {
  const MissionOptions& options = mission.options();
  replay::RecordedSetup setup =
      record_setup(mission.executive().task(), mission.given(), options.robot, mission.settings(),
                   mission.body().description());
  setup.world = options.world;
  setup.seed = options.seed;
  return setup;
}

replay::RecordedSetup setup_of(const RobotMission& mission) {
  const RobotMissionOptions& options = mission.options();
  return record_setup(mission.executive().task(), options.given, options.robot, mission.settings(),
                      mission.body().description());
}

MissionRecorder::MissionRecorder(std::string file, const std::string& memory)
    : file_(std::move(file)) {
  if (file_.empty() || memory.empty()) return;
  memory_known_ = true;
  memory_ = copy_of_memory(memory);
}

void MissionRecorder::begin_with(replay::RecordedSetup setup) {
  setup.memory_known = memory_known_;
  setup.memory = std::move(memory_);
  recorder_ = std::make_unique<Recorder>(file_, setup);
}

void MissionRecorder::take(const CognitiveCycle& cycle, const Executive& executive) {
  if (recorder_) recorder_->take(cycle.trace(), executive);
}

std::string MissionRecorder::finish() {
  if (!recorder_) return {};
  const RecorderReport report = recorder_->finish();
  if (report.lost > 0) {
    fmt::print(stderr, "{}: {} of {} cycles were not recorded: {}\n", file_, report.lost,
               report.kept + report.lost, report.why_lost);
  }
  return fmt::format("{}, {} cycles, {:.1f} MB", file_, report.kept,
                     static_cast<double>(report.bytes) / 1e6);
}

}  // namespace striate
