#include "striate/app/trial/trial.hpp"

#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <optional>

#include "striate/agent/baselines/baseline.hpp"
#include "striate/agent/landmark_knowledge.hpp"
#include "striate/agent/robot_settings.hpp"
#include "striate/agent/run_result.hpp"
#include "striate/app/interrupt.hpp"
#include "striate/app/status_line.hpp"
#include "striate/app/trial/process_pool.hpp"
#include "striate/app/trial/trial_folder.hpp"
#include "striate/app/trial/trial_table.hpp"
#include "striate/base/files.hpp"
#include "striate/base/say.hpp"
#include "striate/base/user_error.hpp"
#include "striate/platform/simulator/world.hpp"
#include "striate/tasks/task_reader.hpp"

namespace striate::app {
namespace {

/// The finished run in this file, nothing if there is none yet or it was interrupted.
std::optional<agent::RunResult> finished(const TrialRun& run, const TrialOptions& options) {
  std::ifstream stream(run.result_file);
  if (!stream) return std::nullopt;
  const auto json = nlohmann::json::parse(stream, nullptr, false);
  if (json.is_discarded()) return std::nullopt;
  agent::RunResult result;
  try {
    result = agent::run_result_from_json(json);
  } catch (const std::runtime_error&) {
    return std::nullopt;
  }
  if (result.world != run.world || result.task != options.task ||
      result.emergency_layer != options.emergency_layer || result.baseline != options.baseline) {
    throw UserError(
        fmt::format("{}: holds a run of another trial ({}, {}, emergency layer {})\n"
                    "    give another --out folder, or remove this one",
                    run.result_file, row_name(result.world, result.baseline), result.task,
                    result.emergency_layer ? "on" : "off"));
  }
  if (!agent::row_of(result.outcome).finished) return std::nullopt;
  return result;
}

void check_options(const TrialOptions& options) {
  if (!options.memory.empty() && !std::filesystem::is_regular_file(options.memory)) {
    throw UserError(fmt::format("{}: there is no such memory", options.memory));
  }
  static_cast<void>(agent::baseline_named(options.baseline));
  for (const std::string& world : options.worlds) {
    if (!std::filesystem::is_regular_file(world)) {
      throw UserError(fmt::format("{}: there is no such world file", world));
    }
    for (const std::string& other : options.worlds) {
      if (&other != &world && world_name(other) == world_name(world)) {
        throw UserError(fmt::format("two worlds have the same name: {} and {}", world, other));
      }
    }
  }
}

/// What would end every run alike is told once, before any.
void check_files(const TrialOptions& options) {
  std::vector<std::string> known;
  if (!options.memory.empty()) known = agent::read_mission_knowledge(options.memory).names();
  std::string notices;
  const agent::RobotSettings settings = agent::load_robot_settings(options.robot, &notices);
  (void)tasks::check_task(options.task, agent::simulated_robot(settings), &known);
  for (const std::string& world : options.worlds) (void)simulator::load_world(world);
}

class Trial {
 public:
  explicit Trial(const TrialOptions& options)
      : options_(options),
        folder_(options.out),
        runs_(plan_trial(options)),
        results_(runs_.size()),
        status_(options.quiet) {
    for (std::size_t i = 0; i < runs_.size(); ++i) {
      results_[i] = finished(runs_[i], options_);
      if (!results_[i]) missing_.push_back(i);
    }
  }

  int run() {
    const std::string program = std::filesystem::canonical("/proc/self/exe").string();
    std::vector<std::vector<std::string>> commands;
    for (const std::size_t i : missing_) {
      commands.push_back(command_of(runs_[i], options_, program));
      if (options_.memory.empty()) continue;
      std::filesystem::copy_file(options_.memory, memory_of(runs_[i]),
                                 std::filesystem::copy_options::overwrite_existing);
    }
    started_ = std::chrono::steady_clock::now();
    show();
    run_processes(
        commands, options_.jobs, [this](const ProcessEnd& end) { take(end); },
        Interrupt::requested);
    status_.clear();
    write();
    fmt::print("{}{}", trial_table(done()),
               replay_commands(done(), options_.robot, options_.memory, options_.plugins));
    if (Interrupt::requested()) {
      fmt::print("\ninterrupted: {} of {} runs are done; the same command goes on from here\n",
                 done().size(), runs_.size());
      return 130;
    }
    return failures_ == 0 ? 0 : 1;
  }

 private:
  [[nodiscard]] std::vector<agent::RunResult> done() const {
    std::vector<agent::RunResult> list;
    for (const auto& result : results_) {
      if (result) list.push_back(*result);
    }
    return list;
  }

  void take(const ProcessEnd& end) {
    const std::size_t index = missing_[end.job];
    results_[index] = finished(runs_[index], options_);
    if (!results_[index] && !Interrupt::requested()) {
      ++failures_;
      status_.clear();
      say(stderr, fmt::format("{} seed {} gave no result (exit code {}):\n{}\n", runs_[index].world,
                              runs_[index].seed, end.exit_code, end.output));
    }
    write();
    show();
  }

  void write() const {
    const std::vector<agent::RunResult> list = done();
    write_file(options_.out + "/runs.csv", runs_csv(list));
    if (!list.empty()) write_file(options_.out + "/table.md", trial_table(list));
  }

  void show() {
    const std::vector<agent::RunResult> list = done();
    int successes = 0;
    for (const agent::RunResult& result : list)
      successes += result.outcome == agent::RunOutcome::success ? 1 : 0;
    const double elapsed_s =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - started_).count();
    const std::size_t now_done = list.size() - (runs_.size() - missing_.size());
    const std::string left =
        now_done == 0 ? ""
                      : fmt::format(", about {:.0f} min left",
                                    elapsed_s / static_cast<double>(now_done) *
                                        static_cast<double>(runs_.size() - list.size()) / 60.0);
    const std::size_t bar = runs_.empty() ? 0 : 30 * list.size() / runs_.size();
    status_.show(fmt::format("[{}{}] {} of {} runs, {} without collision{}", std::string(bar, '#'),
                             std::string(30 - bar, '.'), list.size(), runs_.size(), successes,
                             left));
  }

  const TrialOptions& options_;
  TrialFolder folder_;
  std::vector<TrialRun> runs_;
  std::vector<std::optional<agent::RunResult>> results_;
  std::vector<std::size_t> missing_;
  StatusLine status_;
  std::chrono::steady_clock::time_point started_;
  int failures_ = 0;
};

}  // namespace

int run_trial(const TrialOptions& options) {
  check_options(options);
  check_files(options);
  const Interrupt interrupt(Interrupt::BrokenOutput::ends);
  return Trial(options).run();
}

}  // namespace striate::app
