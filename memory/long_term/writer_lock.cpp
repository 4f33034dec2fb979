#include "striate/memory/long_term/writer_lock.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

#include "striate/base/user_error.hpp"

namespace striate::memory {
namespace {

std::string holder_of(int descriptor) {
  std::array<char, 200> text{};
  const ssize_t size = pread(descriptor, text.data(), text.size(), 0);
  return size > 0 ? std::string(text.data(), static_cast<std::size_t>(size)) : "another process";
}

}  // namespace

WriterLock::WriterLock(const std::string& memory, const std::string& who) {
  const std::string file = memory + "-lock";
  descriptor_ = open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
  if (descriptor_ < 0) {
    throw UserError(
        fmt::format("{}: nothing can be written beside it ({})\n    make its folder writable, or "
                    "copy the memory to a folder of yours",
                    memory, std::strerror(errno)));
  }
  if (flock(descriptor_, LOCK_EX | LOCK_NB) != 0) {
    const std::string holder = holder_of(descriptor_);
    close(descriptor_);
    throw UserError(
        fmt::format("{}: {} is writing into this memory; one session at a time may\n    wait "
                    "until it has ended, or give another file with --memory",
                    memory, holder));
  }
  const std::string text = fmt::format("{} (process {})", who, getpid());
  // What the file says is a courtesy: on a full disk the lock holds all the same.
  if (ftruncate(descriptor_, 0) == 0) {
    [[maybe_unused]] const ssize_t written = pwrite(descriptor_, text.data(), text.size(), 0);
  }
}

WriterLock::~WriterLock() {
  close(descriptor_);
}

}  // namespace striate::memory
