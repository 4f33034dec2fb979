#include <fmt/format.h>

#include <atomic>
#include <cstdio>
#include <thread>

#include "striate/platform/pioneer/pioneer_robot.hpp"
#include "tests/reference/late_lines.hpp"

/// Seconds from the moment a line gets late until the robot stands for good, as a Markdown table.
///   late_lines_table            the drivers under a commander that wants 0.3 m/s
///   late_lines_table STRIATE    a mission of that program
namespace {

using namespace striate;
using reference::kLateLines;
using reference::LateLine;
using reference::LateMission;

/// Wants 0.3 m/s, as a mission does unless its newest image is older than 0.5 s.
class Commander {
 public:
  explicit Commander(const pioneer::DevicePlaces& places)
      : thread_([this, places] {
          try {
            run(places);
          } catch (const std::exception&) {  // the robot is lost: nobody commands any more
          }
        }) {}
  ~Commander() {
    ends_ = true;
    thread_.join();
  }

 private:
  void run(const pioneer::DevicePlaces& places) {
    pioneer::PioneerSettings settings;
    settings.devices = places;
    pioneer::PioneerRobot robot(settings);
    Senses senses;
    while (!ends_) {
      robot.sense(senses);
      const bool old = senses.now - senses.stereo.stamp > std::chrono::milliseconds(500);
      robot.send({.forward_m_s = old ? 0.0 : 0.3, .tilt_rad = -0.2});
    }
  }
  std::atomic<bool> ends_{false};
  std::thread thread_;
};

/// @returns what to write into the table.
std::string stands_after(const std::string& striate, LateLine line, double late_s) {
  LateMission mission(striate, STRIATE_SOURCE_DIR);
  std::unique_ptr<Commander> commander;
  if (striate.empty()) {
    commander = std::make_unique<Commander>(mission.places());
  } else {
    mission.start();
  }
  if (!mission.drives(0.25, 40.0)) return "did not start";
  (void)mission.watch(1.0);
  mission.late(line, late_s);
  const LateMission::Watched seen = mission.watch(8.0 + late_s);
  std::string text = seen.moves_at_the_end || seen.last_moved_s > 7.0
                         ? "drives on and off"
                         : fmt::format("{:.1f}", seen.last_moved_s);
  if (mission.state().collisions > 0) text += " **touched**";
  return text;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string striate = argc > 1 ? argv[1] : "";
  constexpr std::array kDelays_s{0.3, 0.8, 1.5, 3.0};
  fmt::print("| line | 0.3 s | 0.8 s | 1.5 s | 3 s |\n| --- | --- | --- | --- | --- |\n");
  for (std::size_t line = 0; line < kLateLines.size(); ++line) {
    fmt::print("| {} |", kLateLines[line]);
    for (const double late_s : kDelays_s) {
      fmt::print(" {} |", stands_after(striate, static_cast<LateLine>(line), late_s));
      std::fflush(stdout);
    }
    fmt::print("\n");
  }
  return 0;
}
