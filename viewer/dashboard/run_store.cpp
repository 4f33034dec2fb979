#include "striate/viewer/dashboard/run_store.hpp"

#include <unistd.h>

#include <algorithm>
#include <stdexcept>

namespace striate::viewer::dashboard {
namespace {

/// What is longer lies in the file; by hand: images do, and maps of the whole floor.
constexpr std::size_t kInMemory_bytes = 8192;

}  // namespace

RunStore::RunStore() : file_(std::tmpfile(), std::fclose) {
  if (!file_) throw std::runtime_error("no temporary file can be made for the images of the run");
}

void RunStore::put(Topic topic, std::uint64_t time_ns, ByteView message) {
  const std::lock_guard lock(mutex_);
  Stored stored;
  stored.time_ns = time_ns;
  if (message.size() <= kInMemory_bytes) {
    stored.bytes.assign(message.begin(), message.end());
  } else {
    stored.at = written_;
    stored.length = static_cast<std::uint32_t>(message.size());
    for (std::size_t done = 0; done < message.size();) {
      const ssize_t wrote = ::pwrite(fileno(file_.get()), message.data() + done,
                                     message.size() - done, static_cast<off_t>(written_ + done));
      if (wrote <= 0) throw std::runtime_error("the disk has no room for the images of the run");
      done += static_cast<std::size_t>(wrote);
    }
    written_ += message.size();
  }
  messages_[static_cast<std::size_t>(topic)].push_back(std::move(stored));
}

void RunStore::end_cycle() {
  const std::lock_guard lock(mutex_);
  Counts counts{};
  for (std::size_t k = 0; k < kTopics; ++k) {
    counts[k] = static_cast<std::uint32_t>(messages_[k].size());
  }
  until_.push_back(counts);
}

std::size_t RunStore::cycles() const {
  const std::lock_guard lock(mutex_);
  return until_.size();
}

Bytes RunStore::bytes_of(const Stored& stored) const {
  if (stored.length == 0) return stored.bytes;
  Bytes bytes(stored.length);
  const ssize_t got =
      ::pread(fileno(file_.get()), bytes.data(), bytes.size(), static_cast<off_t>(stored.at));
  if (got != static_cast<ssize_t>(bytes.size())) {
    throw std::runtime_error("an image of the run cannot be read again");
  }
  return bytes;
}

void RunStore::add(Topic topic, const Stored& stored, Bytes& to) const {
  const Bytes bytes = bytes_of(stored);
  ByteWriter writer(to);
  writer.u32(static_cast<std::uint32_t>(topic));
  writer.put(stored.time_ns);
  writer.u32(static_cast<std::uint32_t>(bytes.size()));
  append(to, bytes);
}

std::string RunStore::newest(std::size_t cycle, const TopicSet& topics) const {
  const std::lock_guard lock(mutex_);
  Bytes all;
  if (cycle < until_.size()) {
    for (std::size_t k = 0; k < kTopics; ++k) {
      const std::uint32_t count = until_[cycle][k];
      if (topics[k] && count > 0) add(static_cast<Topic>(k), messages_[k][count - 1], all);
    }
  }
  return {all.begin(), all.end()};
}

std::string RunStore::span(std::size_t first, std::size_t last, const TopicSet& topics) const {
  const std::lock_guard lock(mutex_);
  Bytes all;
  if (!until_.empty() && first <= last) {
    const std::size_t end = std::min(last, until_.size() - 1);
    for (std::size_t k = 0; k < kTopics; ++k) {
      if (!topics[k]) continue;
      const std::uint32_t from = first == 0 ? 0 : until_[std::min(first - 1, end)][k];
      for (std::uint32_t m = from; m < until_[end][k]; ++m) {
        add(static_cast<Topic>(k), messages_[k][m], all);
      }
    }
  }
  return {all.begin(), all.end()};
}

std::size_t RunStore::first_difference(const RunStore& one, const RunStore& other, Topic topic) {
  const std::scoped_lock lock(one.mutex_, other.mutex_);
  const auto k = static_cast<std::size_t>(topic);
  const std::size_t cycles = std::min(one.until_.size(), other.until_.size());
  for (std::size_t cycle = 0; cycle < cycles; ++cycle) {
    const std::uint32_t first = one.until_[cycle][k];
    const std::uint32_t second = other.until_[cycle][k];
    if (first != second) return cycle;
    if (first == 0) continue;
    if (one.bytes_of(one.messages_[k][first - 1]) !=
        other.bytes_of(other.messages_[k][second - 1])) {
      return cycle;
    }
  }
  return cycles;
}

}  // namespace striate::viewer::dashboard
