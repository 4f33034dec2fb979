#pragma once

#include <SQLiteCpp/Transaction.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "striate/agent/recall/known_things.hpp"
#include "striate/base/user_error.hpp"
#include "striate/memory/long_term/memory_errors.hpp"
#include "striate/memory/long_term/memory_file.hpp"
#include "striate/memory/long_term/memory_tables.hpp"

namespace striate::python {

/// A long-term memory, opened to read; also while a mission writes it. Any thread may ask.
class MemoryReader {
 public:
  /// @throws UserError as MemoryFile does
  explicit MemoryReader(const std::filesystem::path& file);

  /// Hands its tables to `work` within one transaction, so that all that is read belongs together.
  /// @param doing for the sentence of an error @throws UserError
  template <class Work>
  auto read(const char* doing, Work work) {
    const std::lock_guard one_at_a_time(mutex_);
    return read_locked(doing, work);
  }

  /// What it knows is read at the first look, and again where the file has changed since.
  std::vector<agent::KnownThing> recognise(const cv::Mat3b& picture,
                                           const std::vector<std::string>& only);
  void close();

  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] const std::vector<std::string>& notices() const { return notices_; }
  [[nodiscard]] bool closed() const {
    const std::lock_guard one_at_a_time(mutex_);
    return tables_ == nullptr;
  }

 private:
  template <class Work>
  auto read_locked(const char* doing, Work work) {
    if (!tables_) throw UserError(path_ + ": this memory has been closed");
    try {
      const SQLite::Transaction snapshot(file_->database());
      return work(*tables_);
    } catch (const SQLite::Exception& error) {
      memory::throw_memory_error(path_, doing, error);
    }
  }

  std::unique_ptr<memory::MemoryFile> file_;
  std::unique_ptr<memory::MemoryTables> tables_;  ///< none: it is closed
  std::string path_;
  std::vector<std::string> notices_;
  std::unique_ptr<agent::KnownThings> things_;
  std::vector<std::string> only_;
  std::int64_t known_ = 0;  ///< SQLite counts it up when somebody else has changed the file
  mutable std::mutex mutex_;
};

}  // namespace striate::python
