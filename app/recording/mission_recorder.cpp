#include "app/recording/mission_recorder.hpp"

#include <fmt/format.h>

#include "app/recording/setup.hpp"

namespace striate {

MissionRecorder::MissionRecorder(std::string file, const Mission& mission)
    : file_(std::move(file)) {
  if (file_.empty()) return;
  const MissionOptions& options = mission.options();
  replay::RecordedSetup setup =
      record_setup(mission.executive().task(), mission.given(), options.robot, mission.settings(),
                   mission.body().description());
  setup.world = options.world;
  setup.seed = options.seed;
  setup.memory_known = options.landmarks.has_value();
  if (options.landmarks) setup.landmarks = *options.landmarks;
  recorder_ = std::make_unique<Recorder>(file_, setup);
}

void MissionRecorder::take(const Mission& mission) {
  if (recorder_) recorder_->take(mission.cycle().trace(), mission.executive());
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
