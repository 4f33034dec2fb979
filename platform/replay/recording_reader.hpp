#pragma once

#include <cstdint>
#include <fstream>
#include <istream>
#include <memory>
#include <string>
#include <vector>

#include "striate/platform/replay/recording.hpp"
#include "striate/platform/replay/recording_format.hpp"

namespace striate::replay {

/// How a recording ends.
enum class Ending : std::uint8_t {
  unread,   ///< there is more to come
  closed,   ///< the recorder closed it
  cut_off,  ///< the run was killed, or the disk was full: all whole cycles are there
};

/// Reads a recording from its beginning, cycle after cycle.
class RecordingReader {
 public:
  /// @throws UserError where the file cannot be read, is no recording, is of a newer version, or is
  /// damaged at its head.
  explicit RecordingReader(const std::string& file);
  /// The same from any stream; `name` is for messages.
  RecordingReader(std::unique_ptr<std::istream> stream, std::string name);

  [[nodiscard]] const RecordedSetup& setup() const { return setup_; }
  /// The next cycle, or false at the end. @throws UserError naming the place of any damage.
  bool next(RecordedCycle& cycle);

  [[nodiscard]] Ending ending() const { return ending_; }
  /// How many cycles the run had of which the recorder kept none; known where it was closed.
  [[nodiscard]] std::uint64_t lost() const { return lost_; }
  [[nodiscard]] const std::string& name() const { return name_; }

 private:
  enum class Got : std::uint8_t { chunk, end_of_file };
  void read_head();
  Got read_chunk(Chunk& kind);
  [[noreturn]] void damaged(const std::string& what) const;

  std::unique_ptr<std::istream> stream_;
  std::string name_;
  std::uint64_t at_byte_ = 0;  ///< where the chunk in hand begins
  std::uint64_t last_number_ = 0;
  std::vector<std::uint8_t> payload_;
  RecordedSetup setup_;
  RecordedCycle cycle_;  ///< keeps the images that are not written again
  Ending ending_ = Ending::unread;
  std::uint64_t lost_ = 0;
};

/// Whether a file begins as a recording does.
[[nodiscard]] bool is_recording(const std::string& file);

}  // namespace striate::replay
