#include "striate/viewer/mcap/file_sink.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <pthread.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <stdexcept>
#include <utility>

#include "striate/base/files.hpp"
#include "striate/base/user_error.hpp"

namespace striate::viewer::mcap {

FileSink::FileSink(std::string file) : file_(std::move(file)) {
  check_writable(file_);
  descriptor_ = ::open(file_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (descriptor_ >= 0) return;
  throw UserError(fmt::format("{}: cannot be written: {}", file_, std::strerror(errno)));
}

FileSink::~FileSink() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void FileSink::write(ByteView piece) {
  sigset_t size_limit;
  sigemptyset(&size_limit);
  sigaddset(&size_limit, SIGXFSZ);
  pthread_sigmask(SIG_BLOCK, &size_limit, nullptr);
  std::size_t done = 0;
  while (done < piece.size()) {
    const ssize_t got = ::write(descriptor_, piece.data() + done, piece.size() - done);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) {
      const int error = errno;
      // Where that fails too, readers find the end by themselves.
      (void)!::ftruncate(descriptor_, static_cast<off_t>(bytes_));
      throw std::runtime_error(std::strerror(error));
    }
    done += static_cast<std::size_t>(got);
  }
  bytes_ += piece.size();
}

void FileSink::close() {
  const int descriptor = std::exchange(descriptor_, -1);
  if (descriptor >= 0 && ::close(descriptor) != 0) throw std::runtime_error(std::strerror(errno));
}

}  // namespace striate::viewer::mcap
