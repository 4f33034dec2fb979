#include "striate/app/doctor/machine.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <thread>

#include "striate/base/instruction_set.hpp"

namespace striate::app {
namespace {

using Grade = Finding::Grade;
constexpr double kMega = 1024.0 * 1024.0;  // bytes in a MB, as df and free count
/// A mission with its memory takes some 200 MB, the simulator's light as much again.
constexpr double kLeastMemory_mb = 500.0;
/// MB: room for a recording and the memory (ours)
constexpr double kLeastDisk_mb = 500.0;

std::uint64_t memory_available() {
  std::ifstream file("/proc/meminfo");
  std::string key;
  std::uint64_t kilobytes = 0;
  std::string unit;
  while (file >> key >> kilobytes) {
    if (key == "MemAvailable:") return 1024 * kilobytes;
    std::getline(file, unit);
  }
  return 0;
}

}  // namespace

Machine this_machine() {
  Machine machine;
  machine.cores = std::thread::hardware_concurrency();
  machine.simd = instruction_set();
  machine.memory_bytes = memory_available();
  std::error_code error;
  const auto space = std::filesystem::space(".", error);
  if (!error) machine.disk_free_bytes = space.available;
  return machine;
}

Findings look_at_machine(const Machine& machine) {
  Findings findings;
  const bool one_core = machine.cores < 2;
  findings.push_back(
      {one_core ? Grade::note : Grade::good, "cores", fmt::format("{}", machine.cores),
       one_core ? "the drivers' threads share it with the vision: give the robot two" : ""});
  const bool no_simd = machine.simd.empty() || machine.simd == "SCALAR" || machine.simd == "EMU128";
  findings.push_back(
      {no_simd ? Grade::note : Grade::good, "SIMD",
       no_simd ? "none that the vision can use" : machine.simd,
       no_simd ? "the vision is several times slower: look at the cycle's time" : ""});
  const double memory_mb = static_cast<double>(machine.memory_bytes) / kMega;
  const bool little = memory_mb < kLeastMemory_mb;
  findings.push_back(
      {little ? Grade::wrong : Grade::good, "memory",
       fmt::format("{:.0f} MB can still be had", memory_mb),
       little ? fmt::format("end other programs: a mission wants {:.0f} MB", kLeastMemory_mb)
              : ""});
  const double disk_mb = static_cast<double>(machine.disk_free_bytes) / kMega;
  const bool full = disk_mb < kLeastDisk_mb;
  findings.push_back({full ? Grade::wrong : Grade::good, "disk",
                      fmt::format("{:.0f} MB are free here", disk_mb),
                      full ? "make room: memories and recordings grow" : ""});
  return findings;
}

}  // namespace striate::app
