#pragma once

#include <benchmark/benchmark.h>
#include <hwy/targets.h>

#include <cstdlib>
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

}  // namespace striate
