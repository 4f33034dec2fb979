#include "striate/viewer/recording/mission_mcap.hpp"

#include <fmt/format.h>

#include <exception>
#include <utility>

#include "striate/agent/recording/setup.hpp"

namespace striate::viewer {

MissionMcap::MissionMcap(std::string file, mcap::Compression compression, const std::string& memory)
    : file_(std::move(file)), compression_(compression) {
  if (!file_.empty() && !memory.empty()) memory_ = agent::copy_of_memory(memory);
}

MissionMcap::~MissionMcap() {
  finish();
}

void MissionMcap::begin(const agent::Mission& mission) {
  if (file_.empty()) return;
  replay::RecordedSetup setup = agent::setup_of(mission);
  setup.memory = std::move(memory_);
  writer_ = std::make_unique<FactsFile>(file_, compression_, setup, mission.executive().task());
  thread_ = std::thread([this] { work(); });
}

void MissionMcap::take(const agent::Mission& mission) {
  if (!thread_.joinable()) return;
  const bool taken = ring_.put([&](CycleFacts& facts) {
    taker_.take(mission.cycle(), mission.executive(), mission.cycles(), facts);
  });
  if (!taken) taker_.lost();
}

void MissionMcap::work() {
  while (const CycleFacts* facts = ring_.wait_for_front()) {
    keep(*facts);
    ring_.pop();
  }
}

/// An image that cannot be encoded, or no memory for it, ends the file, not the program.
void MissionMcap::keep(const CycleFacts& facts) noexcept {
  if (failed_) return;
  try {
    writer_->add(facts);
  } catch (const std::exception& error) {
    note_failure(error.what());
  } catch (...) {
    note_failure("an unknown error");
  }
}

void MissionMcap::note_failure(const char* why) noexcept {
  failed_ = true;
  try {
    why_failed_ = why;
  } catch (...) {  // no memory for the words, either
  }
}

agent::RecordingEnd MissionMcap::finish() {
  if (!thread_.joinable()) return {};
  ring_.end();
  thread_.join();
  try {
    if (!failed_) writer_->close();
  } catch (const std::exception& error) {
    note_failure(error.what());
  }
  return end();
}

agent::RecordingEnd MissionMcap::end() const {
  agent::RecordingEnd end;
  const std::uint64_t lost = ring_.lost();
  const std::uint64_t all = ring_.filled() + lost;
  const std::uint64_t whole = writer_->whole_cycles();
  end.failed = failed_;
  if (failed_) {
    end.lost =
        fmt::format("{}: {} of {} cycles are not in it: {}", file_, all - whole, all, why_failed_);
  } else if (lost > 0) {
    end.lost =
        fmt::format("{}: {} of {} cycles are not in it: the robot was faster than its writer",
                    file_, lost, all);
  }
  end.kept = fmt::format("{}, {} cycles, {:.1f} MB", file_, whole,
                         static_cast<double>(writer_->bytes()) / 1e6);
  return end;
}

}  // namespace striate::viewer
