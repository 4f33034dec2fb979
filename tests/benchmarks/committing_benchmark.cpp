#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <vector>

#include "striate/agent/cognitive_cycle.hpp"
#include "striate/agent/mission.hpp"
#include "striate/agent/robot_settings.hpp"
#include "striate/agent/simulated_body.hpp"
#include "striate/memory/long_term/memory_writer.hpp"
#include "striate/tasks/task_reader.hpp"
#include "tests/reference/temporary_folder.hpp"

/// committing_benchmark [CYCLES] [TURNS]: how long a cycle of the robot takes without a long-term
/// memory, and with one that is written in every cycle (a sighting's strength and an episode: some
/// thirty times as often as a mission does), both on the same senses, in turns. The cycles follow
/// each other without a pause, so the disk has ten times less time than on a robot.
namespace striate {
namespace {

/// Gives again what the simulated robot sensed.
class Remembered : public Robot {
 public:
  Remembered(const RobotDescription& description, const std::vector<Senses>& senses)
      : description_(description), senses_(senses) {}
  [[nodiscard]] const RobotDescription& description() const override { return description_; }
  [[nodiscard]] const Clock& clock() const override { return clock_; }
  bool sense(Senses& senses) override {
    if (next_ == senses_.size()) return false;
    senses = senses_[next_++];
    return true;
  }
  void send(const MotorCommand& /*command*/) override {}
  void stop() noexcept override {}

 private:
  class Stopped : public Clock {
   public:
    [[nodiscard]] TimePoint now() const override { return {}; }
  };
  RobotDescription description_;
  const std::vector<Senses>& senses_;
  std::size_t next_ = 0;
  Stopped clock_;
};

agent::MissionOptions mission() {
  agent::MissionOptions options;
  options.task = STRIATE_SOURCE_DIR "/config/tasks/corridor.yaml";
  return options;
}

std::vector<Senses> sensed(std::size_t cycles) {
  std::vector<Senses> all;
  agent::Mission drive(mission(), agent::simulated_pioneer(
                                      {.world = STRIATE_SOURCE_DIR "/config/worlds/short.yaml"}));
  drive.run([&](const agent::Mission& now) {
    all.push_back(now.cycle().trace().senses);
    all.back().stereo.left = all.back().stereo.left.clone();
    all.back().stereo.right = all.back().stereo.right.clone();
    return all.size() >= cycles;
  });
  return all;
}

class Turn {
 public:
  explicit Turn(const std::vector<Senses>& senses)
      : robot_({}, senses),
        settings_(agent::load_robot_settings("")),
        executive_(tasks::load_task(mission().task, {}, {{"way", "100 m"}})),
        cycle_(robot_, settings_, executive_) {}

  /// Milliseconds of each cycle.
  template <class Each>
  void run(std::vector<double>& times_ms, const Each& each) {
    bool goes_on = true;
    while (goes_on) {
      const auto begin = std::chrono::steady_clock::now();
      goes_on = cycle_.step();
      each();
      const std::chrono::duration<double, std::milli> took =
          std::chrono::steady_clock::now() - begin;
      times_ms.push_back(took.count());
    }
  }

 private:
  Remembered robot_;
  agent::RobotSettings settings_;
  tasks::Executive executive_;
  agent::CognitiveCycle cycle_;
};

double percentile(std::vector<double>& values, double share) {
  const auto place = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + place, values.end());
  return values[static_cast<std::size_t>(place)];
}

int run(std::size_t cycles, int turns) {
  const reference::TemporaryFolder folder;
  const std::vector<Senses> senses = sensed(cycles);
  memory::MemoryOptions options;
  options.access = memory::Access::session;
  std::vector<double> without_ms, with_ms;
  for (int turn = 0; turn < turns; ++turn) {
    Turn(senses).run(without_ms, [] {});
    memory::MemoryWriter writer(folder / fmt::format("{}.db", turn), options);
    std::int64_t session = 0;
    writer.commit([&](memory::MemoryTables& tables) {
      session = tables.sessions.begin(memory::SessionKind::mission, "benchmark", "", 0).id;
    });
    double now_s = 0.0;
    Turn(senses).run(with_ms, [&] {
      now_s += 0.1;
      writer.post([session, now_s](memory::MemoryTables& tables) {
        memory::Episode episode;
        episode.session = session;
        episode.time_s = now_s;
        episode.kind = "seen";
        episode.text = "a cup, 1.2 m ahead";
        tables.sessions.add(episode);
        tables.sessions.note_time(session, now_s);
      });
    });
    if (writer.lost() > 0) fmt::print("{} posts were lost\n", writer.lost());
  }
  fmt::print("{} cycles each, ms        median      99 %\n", without_ms.size());
  for (const auto& [name, times] : {std::pair{"without a memory     ", &without_ms},
                                    std::pair{"committing each cycle", &with_ms}}) {
    fmt::print("{}  {:10.2f}{:10.2f}\n", name, percentile(*times, 0.5), percentile(*times, 0.99));
  }
  fmt::print("99 % with / without: {:.3f}\n",
             percentile(with_ms, 0.99) / percentile(without_ms, 0.99));
  return 0;
}

}  // namespace
}  // namespace striate

int main(int argc, char** argv) {
  return striate::run(argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 300,
                      argc > 2 ? std::atoi(argv[2]) : 7);
}
