#include "striate/memory/long_term/writer_lock.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

#include "striate/base/user_error.hpp"

namespace striate::memory {
namespace {

/// "striate run (process 123)" of a process that can be looked at: its program and first word.
std::string process_text(long process) {
  std::ifstream words(fmt::format("/proc/{}/cmdline", process), std::ios::binary);
  std::string program;
  std::string command;
  std::getline(words, program, '\0');
  std::getline(words, command, '\0');
  program.erase(0, program.rfind('/') + 1);
  if (program.empty()) return fmt::format("process {}", process);
  if (!command.empty() && command.front() == '-') command.clear();  // an option, no command
  return fmt::format("{}{}{} (process {})", program, command.empty() ? "" : " ", command, process);
}

/// The kernel lists who holds which lock: "1: FLOCK ADVISORY WRITE 123 fe:00:4567 0 EOF".
std::string holder_of(int descriptor) {
  struct stat status {};
  if (fstat(descriptor, &status) == 0) {
    const std::string wanted =
        fmt::format("{:02x}:{:02x}:{}", major(status.st_dev), minor(status.st_dev), status.st_ino);
    std::ifstream locks("/proc/locks");
    for (std::string line; std::getline(locks, line);) {
      std::istringstream words(line);
      std::string number, kind, advisory, access, file;
      long process = 0;
      words >> number >> kind >> advisory >> access >> process >> file;
      if (kind == "FLOCK" && file == wanted && process > 0) return process_text(process);
    }
  }
  return "another process";
}

}  // namespace

WriterLock::WriterLock(const std::string& memory) {
  // The file is the memory: whoever opens it by whatever name meets the same lock.
  descriptor_ = open(memory.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
  if (descriptor_ < 0) {
    throw UserError(fmt::format(
        "{}: it cannot be written ({})\n    make it and its folder writable, or copy the "
        "memory to a folder of yours",
        memory, std::strerror(errno)));
  }
  if (flock(descriptor_, LOCK_EX | LOCK_NB) == 0) return;
  const std::string holder = holder_of(descriptor_);
  close(descriptor_);
  throw UserError(fmt::format(
      "{}: {} is writing into this memory; one session at a time may\n    wait until it "
      "has ended, or give another file with --memory",
      memory, holder));
}

WriterLock::~WriterLock() {
  close(descriptor_);
}

}  // namespace striate::memory
