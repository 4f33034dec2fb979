#include "striate/memory/long_term/memory_writer.hpp"

#include <SQLiteCpp/Transaction.h>

#include "striate/memory/long_term/memory_errors.hpp"

namespace striate::memory {
namespace {

MemoryOptions as_session(MemoryOptions options) {
  options.access = Access::session;
  return options;
}

}  // namespace

MemoryWriter::MemoryWriter(const std::string& path, const MemoryOptions& options)
    : file_(path, as_session(options)), tables_(file_.database()) {
  posted_.reserve(kMostQueued);
  thread_ = std::thread([this] { work(); });
}

MemoryWriter::~MemoryWriter() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  wake_.notify_one();
  thread_.join();
}

void MemoryWriter::post(Job job) {
  {
    const std::lock_guard lock(mutex_);
    if (posted_.size() >= kMostQueued) {
      ++lost_;
      why_lost_ = "more was to be kept than the disk takes in";
      return;
    }
    posted_.push_back(std::move(job));
  }
  wake_.notify_one();
}

void MemoryWriter::commit(const Job& job) {
  const std::lock_guard turn(one_teacher_);
  std::unique_lock lock(mutex_);
  taught_error_ = nullptr;
  taught_ = &job;
  wake_.notify_one();
  done_.wait(lock, [this] { return taught_ == nullptr; });
  if (taught_error_ != nullptr) std::rethrow_exception(taught_error_);
}

std::uint64_t MemoryWriter::lost() const {
  const std::lock_guard lock(mutex_);
  return lost_;
}

std::string MemoryWriter::why_lost() const {
  const std::lock_guard lock(mutex_);
  return why_lost_;
}

void MemoryWriter::work() {
  std::vector<Job> jobs;
  jobs.reserve(kMostQueued);
  std::unique_lock lock(mutex_);
  while (true) {
    wake_.wait(lock, [this] { return ending_ || !posted_.empty() || taught_ != nullptr; });
    const Job* taught = taught_;
    if (posted_.empty() && taught == nullptr) return;
    jobs.swap(posted_);
    lock.unlock();
    commit_posted(jobs);
    jobs.clear();
    std::exception_ptr error;
    if (taught != nullptr) {
      try {
        commit_taught(*taught);
      } catch (...) {
        error = std::current_exception();
      }
    }
    lock.lock();
    if (taught == nullptr) continue;
    taught_error_ = error;
    taught_ = nullptr;
    done_.notify_all();
  }
}

void MemoryWriter::commit_posted(std::vector<Job>& jobs) {
  if (jobs.empty()) return;
  try {
    try {
      set_synchronous(false);
      SQLite::Transaction transaction(file_.database(), SQLite::TransactionBehavior::IMMEDIATE);
      for (const Job& job : jobs) job(tables_);
      transaction.commit();
      return;
    } catch (const SQLite::Exception& error) {
      throw_memory_error(file_.path(), "keeping what happened", error);
    }
  } catch (const std::exception& error) {
    note_loss(jobs.size(), error.what());
  } catch (...) {
    note_loss(jobs.size(), "an unknown error");
  }
}

/// In the writer's thread, which nothing may end before its program.
void MemoryWriter::note_loss(std::size_t jobs, const char* why) noexcept {
  const std::lock_guard lock(mutex_);
  lost_ += jobs;
  try {
    why_lost_ = why;
  } catch (...) {  // no memory for the words, either
  }
}

void MemoryWriter::commit_taught(const Job& job) {
  try {
    set_synchronous(true);
    SQLite::Transaction transaction(file_.database(), SQLite::TransactionBehavior::IMMEDIATE);
    job(tables_);
    transaction.commit();
  } catch (const SQLite::Exception& error) {
    throw_memory_error(file_.path(), "keeping what was taught", error);
  }
}

void MemoryWriter::set_synchronous(bool full) {
  if (full == full_) return;
  file_.database().exec(full ? "PRAGMA synchronous = FULL" : "PRAGMA synchronous = NORMAL");
  full_ = full;
}

}  // namespace striate::memory
