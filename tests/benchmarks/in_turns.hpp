#pragma once

#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <hwy/targets.h>

#include <cstdlib>
#include <functional>
#include <map>
#include <opencv2/core/utility.hpp>
#include <string>
#include <vector>

namespace striate {

/// Starts Google Benchmark so that methods run in turns on one thread: a machine that slows down
/// slows all of them. The command line's own flags come later and win. STRIATE_TARGETS (a number,
/// see hwy/targets.h) restricts the instruction sets of our own code.
class InTurns {
 public:
  InTurns(int argc, char** argv, int repetitions, const std::string& least_s)
      : arguments_(argv, argv + argc) {
    cv::setNumThreads(1);
    arguments_.insert(
        arguments_.begin() + 1,
        {"--benchmark_enable_random_interleaving=true",
         "--benchmark_repetitions=" + std::to_string(repetitions),
         "--benchmark_min_time=" + least_s, "--benchmark_display_aggregates_only=true"});
    for (std::string& argument : arguments_) pointers_.push_back(argument.data());
    count_ = static_cast<int>(pointers_.size());
    benchmark::Initialize(&count_, pointers_.data());
    if (const char* targets = std::getenv("STRIATE_TARGETS")) {
      hwy::SetSupportedTargetsForTest(std::atoll(targets));
    }
  }

  /// What Google Benchmark did not take, the program's name first.
  [[nodiscard]] int count() const { return count_; }
  [[nodiscard]] char** arguments() { return pointers_.data(); }
  /// Says so and is true if anything was left.
  [[nodiscard]] bool refuse_arguments() {
    return benchmark::ReportUnrecognizedArguments(count_, pointers_.data());
  }

 private:
  std::vector<std::string> arguments_;
  std::vector<char*> pointers_;
  int count_ = 0;
};

/// Reports as usual and gathers the medians of CPU time.
class Medians : public benchmark::ConsoleReporter {
 public:
  void ReportRuns(const std::vector<Run>& runs) override {
    ConsoleReporter::ReportRuns(runs);
    for (const Run& run : runs) {
      if (run.aggregate_name != "median") continue;
      names_.push_back(run.run_name.function_name);
      cpu_time_[names_.back()] = run.GetAdjustedCPUTime();
    }
  }
  /// Each median as a multiple of its yardstick's.
  /// @param yardstick_of the name of the yardstick of a method; one that did not run is left out.
  void print_ratios(const std::function<std::string(const std::string&)>& yardstick_of) const {
    fmt::print("\n{:44} {:>10} {:>8}\n", "median CPU time", "", "ratio");
    for (const std::string& name : names_) {
      const auto yardstick = cpu_time_.find(yardstick_of(name));
      const double time = cpu_time_.at(name);
      fmt::print(
          "{:44} {:10.2f} {:>8}\n", name, time,
          yardstick == cpu_time_.end() ? "" : fmt::format("{:.2f}", time / yardstick->second));
    }
  }
  [[nodiscard]] const std::map<std::string, double>& cpu_time() const { return cpu_time_; }

 private:
  std::vector<std::string> names_;
  std::map<std::string, double> cpu_time_;
};

}  // namespace striate
