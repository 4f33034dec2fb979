// Runs a mission in the simulator from your own program, which looks on after every cycle.
#include <cstdio>
#include <exception>
#include <opencv2/imgcodecs.hpp>
#include <string>

#include "striate/agent/mission.hpp"
#include "striate/agent/pictures/plan_picture.hpp"
#include "striate/agent/simulated_body.hpp"

namespace {

constexpr int kTold_cycles = 20;   // two seconds
constexpr double kMost_s = 120.0;  // the mission takes 20 s; then something is wrong

/// One line every two seconds: where the robot is, what it does and why.
void tell(const striate::agent::Mission& mission) {
  if (mission.cycles() % kTold_cycles != 0) return;
  const striate::agent::CognitiveCycle& cycle = mission.cycle();
  const striate::agent::CycleTrace& trace = cycle.trace();
  const std::string action(mission.executive().current_action());
  std::printf("%5.1f s  %4.1f m  %.2f m/s  %zu obstacles  %s: %s\n",
              striate::to_seconds(trace.senses.now), cycle.memory().progress_m(),
              trace.senses.odometry.forward_m_s, trace.percept.obstacles.size(), action.c_str(),
              striate::agent::doing_text(trace.wish.why, trace.limited_by).c_str());
}

}  // namespace

int main(int count, char** words) try {
  if (count < 3) {
    std::fprintf(stderr, "mission TASK.yaml WORLD.yaml [FOLDER]\n");
    return 2;
  }
  const std::string folder = count > 3 ? words[3] : ".";
  striate::agent::MissionOptions options;
  options.task = words[1];
  options.given = {{"cruise", "0.5 m/s"}};  // a variable that the task declares
  striate::agent::WorldOptions world;
  world.world = words[2];
  world.seed = 3;  // the same seed is the same run, bit for bit

  striate::agent::Mission mission(options, striate::agent::simulated_pioneer(world));
  const striate::agent::RunResult result = mission.run([](const striate::agent::Mission& now) {
    tell(now);
    // True asks for a safe end: the task's `finally` runs, and the robot stands.
    return striate::to_seconds(now.cycle().trace().senses.now) > kMost_s;
  });

  std::printf("%s after %.1f m and %.1f s; nearest pass %.2f m, %zu collisions\n",
              striate::agent::outcome_text(result).c_str(), result.distance_m, result.duration_s,
              result.nearest_pass_m, result.collisions.size());
  const striate::agent::SimulatedBody& body = *mission.simulated();
  const std::string plan = folder + "/plan.png";
  const cv::Mat3b picture = striate::agent::pictures::draw_plan(
      body.world(), body.plan(), body.judge(), &body.light(), "a mission from code");
  if (!cv::imwrite(plan, picture)) return 1;
  std::printf("%s shows the way that it drove\n", plan.c_str());
  return result.outcome == striate::agent::RunOutcome::success ? 0 : 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
