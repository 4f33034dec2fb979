#include "striate/app/status_line.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdio>

#include "striate/base/say.hpp"

namespace striate::app {
namespace {

std::size_t status_width() {
  winsize size{};
  if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 20) return size.ws_col;
  return 100;
}

}  // namespace

StatusLine::StatusLine(bool quiet)
    : quiet_(quiet), terminal_(isatty(STDERR_FILENO) == 1), last_(WallClock::time_point::min()) {}

StatusLine::~StatusLine() {
  clear();
}

bool StatusLine::due() const {
  if (quiet_) return false;
  if (last_ == WallClock::time_point::min()) return true;
  return WallClock::now() - last_ >
         (terminal_ ? std::chrono::milliseconds(100) : std::chrono::milliseconds(10000));
}

std::size_t StatusLine::columns() const {
  return terminal_ ? status_width() - 1 : std::string::npos;
}

void StatusLine::show(const std::string& text) {
  if (quiet_) return;
  last_ = WallClock::now();
  if (terminal_) {
    put("\r\033[K" + text.substr(0, columns()));
    shown_ = true;
  } else {
    put(text + "\n");
  }
}

void StatusLine::tell(const std::string& text) {
  if (quiet_) return;
  clear();
  put(text + "\n");
}

void StatusLine::put(std::string_view text) noexcept {
  if (!say_without_waiting(stderr, text)) failed_ = true;
}

void StatusLine::clear() {
  if (!terminal_ || !shown_) return;
  put("\r\033[K");
  shown_ = false;
}

}  // namespace striate::app
