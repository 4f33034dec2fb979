#include <filesystem>
#include <fstream>
#include <memory>

#include "striate/agent/pictures/cycle_sheet.hpp"
#include "striate/agent/recording/mission_recorder.hpp"
#include "striate/agent/replay/replay_mission.hpp"
#include "striate/agent/simulated_body.hpp"
#include "striate/base/files.hpp"
#include "striate/base/user_error.hpp"
#include "tests/fuzz/fuzz_target.hpp"
#include "tests/fuzz/odd_numbers.hpp"
#include "tests/reference/recorded_cycles.hpp"

using namespace striate;

namespace {

/// Cycles of the mission that is recorded: the eyes have seen some images, and it drives.
constexpr int kCycles = 8;

struct Recorded {
  replay::RecordedSetup setup;
  std::vector<replay::RecordedCycle> cycles;
};

const ScratchFolder& folder() {
  static const ScratchFolder scratch;
  return scratch;
}

/// A short simulated mission with small images.
Recorded record_a_mission() {
  const std::string file = folder() / "good.rec";
  agent::MissionOptions options;
  options.task = STRIATE_SOURCE_DIR "/config/tasks/corridor.yaml";
  options.robot = folder() / "robot.yaml";
  write_file(options.robot, "camera: {width: 160}\n");
  agent::WorldOptions world;
  world.world = STRIATE_SOURCE_DIR "/config/worlds/short.yaml";
  agent::Mission mission(options, agent::simulated_pioneer(world));
  agent::MissionRecorder recorder(file, "");
  recorder.begin(mission);
  for (int k = 0; k < kCycles && mission.step(); ++k) recorder.take(mission);
  (void)recorder.finish();
  Recorded recorded;
  replay::RecordingReader reader(file);
  recorded.setup = reader.setup();
  for (replay::RecordedCycle cycle; reader.next(cycle);) recorded.cycles.push_back(cycle);
  return recorded;
}

const Recorded& good() {
  static const Recorded recorded = record_a_mission();
  return recorded;
}

void add_numbers(RobotDescription& robot, std::vector<double*>& numbers) {
  for (double* number :
       {&robot.front_m, &robot.rear_m, &robot.half_width_m, &robot.corner_m, &robot.max_forward_m_s,
        &robot.max_turn_rad_s, &robot.max_acceleration_m_s2, &robot.max_turn_acceleration_rad_s2,
        &robot.camera_height_m, &robot.camera_forward_m, &robot.view_rad, &robot.resting_tilt_rad,
        &robot.max_pan_rad, &robot.max_tilt_rad}) {
    numbers.push_back(number);
  }
}

void add_numbers(Senses& senses, std::vector<double*>& numbers) {
  StereoFrame& eyes = senses.stereo;
  Odometry& odometry = senses.odometry;
  for (double* number :
       {&eyes.focal_px, &eyes.centre_u_px, &eyes.centre_v_px, &eyes.baseline_m, &eyes.head.pan_rad,
        &eyes.head.tilt_rad, &odometry.pose.x_m, &odometry.pose.y_m, &odometry.pose.heading_rad,
        &odometry.forward_m_s, &odometry.turn_rad_s, &senses.head.pan_rad, &senses.head.tilt_rad,
        &senses.battery_v}) {
    numbers.push_back(number);
  }
  for (RangeScan* scan : {&senses.sonar, &senses.laser}) {
    if (scan->readings.empty()) continue;
    numbers.push_back(&scan->readings.front().bearing_rad);
    numbers.push_back(&scan->readings.front().distance_m);
  }
}

void change(Recorded& recorded, fuzz::OddNumbers& odd) {
  std::vector<double*> numbers;
  std::vector<TimePoint*> times;
  add_numbers(recorded.setup.robot, numbers);
  for (replay::RecordedCycle& cycle : recorded.cycles) {
    add_numbers(cycle.senses, numbers);
    times.insert(times.end(), {&cycle.senses.now, &cycle.senses.stereo.stamp,
                               &cycle.senses.odometry.stamp, &cycle.senses.laser.stamp});
  }
  while (odd.next()) {
    const std::size_t which = odd.which(numbers.size() + times.size() + 1);
    if (which < numbers.size()) {
      *numbers[which] = odd.changed(*numbers[which]);
    } else if (which < numbers.size() + times.size()) {
      *times[which - numbers.size()] =
          TimePoint(Duration(static_cast<std::int64_t>(odd.raw()) >> odd.which(48)));
    } else {
      recorded.setup.robot.cycle = Duration(static_cast<std::int64_t>(odd.raw()) >> odd.which(48));
    }
  }
}

}  // namespace

/// The input changes numbers of a good recording, whose checksums are made anew; then the whole
/// robot runs on it, and is drawn.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Recorded recorded = good();
  fuzz::OddNumbers odd(data, size);
  change(recorded, odd);
  const std::string file = folder() / "odd.rec";
  const std::string bytes = reference::recording_of(recorded.setup, recorded.cycles);
  std::ofstream(file, std::ios::binary) << bytes;
  try {
    agent::ReplayMission mission({file, {}, {}});
    while (mission.step()) (void)mission.differences();
    (void)agent::pictures::draw_cycle_sheet(mission.cycle(), mission.robot(), mission.trajectory(),
                                            "odd");
  } catch (const UserError&) {
  }
  return 0;
}

std::vector<std::string> striate::fuzz::seeds() {
  (void)good();
  return fuzz::lists_of_changes();
}
