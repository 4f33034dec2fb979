#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "striate/platform/replay/recording.hpp"
#include "striate/viewer/channels/channels.hpp"
#include "striate/viewer/mcap/file_sink.hpp"
#include "striate/viewer/mcap/mcap_writer.hpp"

namespace striate::viewer {

/// The facts of a run as an MCAP file. Times are the mission's clock, zero where the body started:
/// the clock has no date, and with one the same run would not give the same file.
class FactsFile {
 public:
  /// Writes the head: what the run was begun with as metadata and attachments.
  /// @throws UserError where it cannot be written
  FactsFile(const std::string& file, mcap::Compression compression,
            const replay::RecordedSetup& setup, const tasks::Task& task);

  /// @throws std::runtime_error where it cannot be written on; the file is then whole up to its
  /// last chunk, and ends there
  void add(const CycleFacts& facts);
  /// The summary. @throws std::runtime_error
  void close();
  /// Cycles that are wholly in the file.
  [[nodiscard]] std::uint64_t whole_cycles() const { return whole_; }
  [[nodiscard]] std::uint64_t bytes() const { return sink_.bytes(); }

 private:
  void write_head(const replay::RecordedSetup& setup);

  mcap::FileSink sink_;
  mcap::Writer writer_;
  Channels channels_;
  std::vector<std::uint16_t> ids_;  ///< of the channels in the file, by Topic
  std::uint64_t added_ = 0;
  std::uint64_t whole_ = 0;
};

}  // namespace striate::viewer
