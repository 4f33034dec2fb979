#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <string>

#include "striate/tasks/executive.hpp"
#include "tests/benchmarks/in_turns.hpp"
#include "tests/reference/fifty_nodes.hpp"

/// task_benchmark: one tick of a tree of 50 nodes, all of which are ticked in each cycle, and the
/// time of a node.
int main(int argc, char** argv) {
  using namespace striate;
  InTurns turns(argc, argv, 9, "0.05");
  if (turns.refuse_arguments()) return 2;
  const memory::ShortTermMemory memory({}, {});
  reference::FiftyNodes tree;
  tasks::Executive executive(std::move(tree.task));
  benchmark::RegisterBenchmark("tick of 50 nodes", [&](benchmark::State& state) {
    TimePoint now{};
    for (auto _ : state) benchmark::DoNotOptimize(executive.tick(memory, now));
    state.counters["a node"] =
        benchmark::Counter(static_cast<double>(state.iterations()) * reference::FiftyNodes::kNodes,
                           benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  });
  benchmark::RunSpecifiedBenchmarks();
  return executive.ended() ? 1 : 0;
}
