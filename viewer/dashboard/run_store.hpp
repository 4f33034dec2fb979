#pragma once

#include <array>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "striate/base/bytes.hpp"
#include "striate/viewer/channels/channel_list.hpp"

namespace striate::viewer::dashboard {

/// The messages of a run by cycle, to look at any of them: written by one thread while another one
/// reads. Images lie in a file without a name, the rest in memory.
class RunStore {
 public:
  /// @throws std::runtime_error where no temporary file can be made
  RunStore();

  /// A message of the cycle in hand. @throws std::runtime_error where the disk is full
  void put(Topic topic, std::uint64_t time_ns, ByteView message);
  /// The cycle in hand is whole.
  void end_cycle();

  [[nodiscard]] std::size_t cycles() const;
  /// The newest message of each topic as it was at the end of that cycle, from 0. One after the
  /// other: topic (u32), time in ns (u64), count of bytes (u32), bytes.
  [[nodiscard]] std::string newest(std::size_t cycle, const TopicSet& topics) const;
  /// All messages of these cycles, first to last, in the same form, topic after topic.
  [[nodiscard]] std::string span(std::size_t first, std::size_t last, const TopicSet& topics) const;
  /// The first cycle in which the two say something else of this topic; cycles() of the shorter
  /// where none does.
  [[nodiscard]] static std::size_t first_difference(const RunStore& one, const RunStore& other,
                                                    Topic topic);

 private:
  struct Stored {
    std::uint64_t time_ns = 0;
    Bytes bytes;               ///< empty where it lies in the file
    std::uint64_t at = 0;      ///< in the file
    std::uint32_t length = 0;  ///< there
  };
  using Counts = std::array<std::uint32_t, kTopics>;

  [[nodiscard]] Bytes bytes_of(const Stored& stored) const;
  void add(Topic topic, const Stored& stored, Bytes& to) const;

  mutable std::mutex mutex_;  ///< guards all that follows
  std::array<std::vector<Stored>, kTopics> messages_;
  std::vector<Counts> until_;  ///< of each cycle: how many messages of each topic, with it
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
  std::uint64_t written_ = 0;
};

}  // namespace striate::viewer::dashboard
