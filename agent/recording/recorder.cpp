#include "striate/agent/recording/recorder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <pthread.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <exception>

#include "striate/agent/recording/decision.hpp"
#include "striate/base/files.hpp"
#include "striate/base/user_error.hpp"
#include "striate/platform/replay/recording_codec.hpp"
#include "striate/platform/replay/recording_format.hpp"

namespace striate::agent {
namespace {

/// Makes a write beyond the limit on file sizes fail with an error instead of ending the program.
void ignore_size_limit() {
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, SIGXFSZ);
  pthread_sigmask(SIG_BLOCK, &set, nullptr);
}

}  // namespace

Recorder::Recorder(const std::string& file, const replay::RecordedSetup& setup) : file_(file) {
  check_writable(file);
  descriptor_ = ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (descriptor_ < 0) {
    throw UserError(fmt::format("{}: cannot be written: {}", file, std::strerror(errno)));
  }
  std::vector<std::uint8_t> head = replay::file_head();
  replay::append_chunk(head, replay::Chunk::setup, replay::encode(setup));
  if (!write(head)) {
    ::close(descriptor_);
    throw UserError(fmt::format("{}: cannot be written: {}", file, report_.why_lost));
  }
  thread_ = std::thread([this] {
    ignore_size_limit();
    work();
  });
}

Recorder::~Recorder() {
  finish();
}

void Recorder::take(const CycleTrace& trace, const tasks::Executive& executive) {
  ++number_;
  {
    const std::lock_guard lock(mutex_);
    if (filled_ - emptied_ == kSlots) {
      ++report_.lost;
      if (report_.why_lost.empty()) report_.why_lost = "the disk takes in less than is recorded";
      return;
    }
  }
  // The slot is this side's until it is counted as filled.
  fill(slots_[filled_ % kSlots], trace, executive);
  {
    const std::lock_guard lock(mutex_);
    ++filled_;
  }
  wake_.notify_one();
}

/// Copies into buffers that are there already: the body may use its own again.
void Recorder::fill(Slot& slot, const CycleTrace& trace, const tasks::Executive& executive) {
  const Senses& from = trace.senses;
  Senses& to = slot.cycle.senses;
  slot.cycle.number = number_;
  slot.same_images =
      images_queued_ && !from.stereo.left.empty() && from.stereo.stamp == images_stamp_;
  cv::Mat3b left = to.stereo.left;
  cv::Mat3b right = to.stereo.right;
  if (!slot.same_images) {
    from.stereo.left.copyTo(left);
    from.stereo.right.copyTo(right);
    images_queued_ = !from.stereo.left.empty();
    images_stamp_ = from.stereo.stamp;
  }
  to = from;
  to.stereo.left = left;
  to.stereo.right = right;
  note_decision(trace, executive, slot.cycle.decision);
  // Tasks are ended from outside between two cycles only, after the first was taken.
  slot.cycle.decision.interrupted = executive.interrupted();
}

void Recorder::work() {
  std::unique_lock lock(mutex_);
  while (true) {
    wake_.wait(lock, [this] { return ending_ || emptied_ < filled_; });
    if (emptied_ == filled_) return;
    const Slot& slot = slots_[emptied_ % kSlots];
    lock.unlock();
    keep(slot);
    lock.lock();
    ++emptied_;
  }
}

void Recorder::keep(const Slot& slot) {
  if (!failed_) failed_ = !write_cycle(slot);
  const std::lock_guard lock(mutex_);
  ++(failed_ ? report_.lost : report_.kept);
}

/// An image that cannot be encoded, or no memory for it, ends the recording, not the program.
bool Recorder::write_cycle(const Slot& slot) {
  try {
    replay::encode(slot.cycle, slot.same_images, payload_);
    chunk_.clear();
    replay::append_chunk(chunk_, replay::Chunk::cycle, payload_);
    return write(chunk_);
  } catch (const std::exception& error) {
    note_failure(error.what());
  } catch (...) {
    note_failure("an unknown error");
  }
  return false;
}

void Recorder::note_failure(const char* why) noexcept {
  const std::lock_guard lock(mutex_);
  try {
    report_.why_lost = why;
  } catch (...) {  // no memory for the words, either
  }
}

/// All or nothing: what was written in part is cut off again.
bool Recorder::write(const std::vector<std::uint8_t>& bytes) {
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t got = ::write(descriptor_, bytes.data() + done, bytes.size() - done);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) {
      const int error = errno;
      // Where that fails too, readers find the end by themselves.
      (void)!::ftruncate(descriptor_, static_cast<off_t>(whole_bytes_));
      note_failure(std::strerror(error));
      return false;
    }
    done += static_cast<std::size_t>(got);
  }
  whole_bytes_ += bytes.size();
  return true;
}

void Recorder::close_file() {
  if (!failed_) {
    payload_.clear();
    ByteWriter(payload_).put(report_.lost);
    chunk_.clear();
    replay::append_chunk(chunk_, replay::Chunk::end, payload_);
    failed_ = !write(chunk_);
  }
  // Some disks say only now that they were full.
  if (::close(descriptor_) != 0 && !failed_) {
    failed_ = true;
    note_failure(std::strerror(errno));
  }
  descriptor_ = -1;
  report_.failed = failed_;
  report_.bytes = whole_bytes_;
}

RecorderReport Recorder::finish() {
  if (descriptor_ < 0) return report_;
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  wake_.notify_one();
  thread_.join();
  close_file();
  return report_;
}

}  // namespace striate::agent
