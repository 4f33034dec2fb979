#include "striate/agent/recall/live_memory.hpp"

#include "striate/agent/memory_json.hpp"
#include "striate/agent/recall/memory_state.hpp"
#include "striate/base/files.hpp"

namespace striate::agent {
namespace {

constexpr std::chrono::seconds kEvery(1);

}  // namespace

LiveMemory::LiveMemory(std::string file) : file_(std::move(file)) {
  if (file_.empty()) return;
  check_writable(file_);
  thread_ = std::thread([this] { work(); });
}

LiveMemory::~LiveMemory() {
  finish();
}

void LiveMemory::take(const CognitiveCycle& cycle, const tasks::Executive& executive,
                      std::uint64_t number) {
  if (file_.empty()) return;
  // What time it is decides only when a person's view is renewed, nothing that the robot does.
  const auto now = std::chrono::steady_clock::now();
  if (now - taken_ < kEvery) return;
  taken_ = now;
  nlohmann::ordered_json state = memory_state(cycle, executive, number);
  {
    const std::lock_guard lock(mutex_);
    mailbox_ = std::move(state);
  }
  wake_.notify_one();
}

/// @return why it could not be written
std::string LiveMemory::keep(const nlohmann::ordered_json& state) const {
  try {
    write_file(file_, print_json(state));
  } catch (const std::exception& error) {
    return error.what();
  } catch (...) {
    return "an unknown error";
  }
  return {};
}

void LiveMemory::work() {
  std::unique_lock lock(mutex_);
  while (true) {
    wake_.wait(lock, [this] { return ending_ || mailbox_; });
    if (!mailbox_) return;
    const nlohmann::ordered_json state = std::move(*mailbox_);
    mailbox_.reset();
    lock.unlock();
    const std::string why = keep(state);
    lock.lock();
    why_lost_ = why;
  }
}

std::string LiveMemory::finish() {
  if (!thread_.joinable()) return {};
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  wake_.notify_one();
  thread_.join();
  return why_lost_;
}

}  // namespace striate::agent
