#include "striate/python/memory_reader.hpp"

#include <SQLiteCpp/Column.h>

#include "striate/agent/landmark_knowledge.hpp"
#include "striate/agent/open_memory.hpp"

namespace striate::python {

MemoryReader::MemoryReader(const std::filesystem::path& file)
    : file_(std::make_unique<memory::MemoryFile>(
          file.string(), agent::memory_options(memory::Access::read, "striate from Python"))),
      tables_(std::make_unique<memory::MemoryTables>(file_->database())),
      path_(file.string()),
      notices_(file_->notices()) {}

std::vector<agent::KnownThing> MemoryReader::recognise(const cv::Mat3b& picture,
                                                       const std::vector<std::string>& only) {
  const std::lock_guard one_at_a_time(mutex_);
  read_locked("looking up its landmarks", [&](memory::MemoryTables& tables) {
    const std::int64_t now = file_->database().execAndGet("PRAGMA data_version").getInt64();
    if (things_ && only == only_ && now == known_) return;
    things_ = std::make_unique<agent::KnownThings>(agent::landmark_knowledge_of(tables),
                                                   perception::RecognitionSettings{}, only);
    only_ = only;
    known_ = now;
  });
  return things_->find(picture);
}

void MemoryReader::close() {
  const std::lock_guard one_at_a_time(mutex_);
  tables_.reset();
  things_.reset();
  file_.reset();
}

}  // namespace striate::python
