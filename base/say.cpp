#include "striate/base/say.hpp"

#include <poll.h>

#include <algorithm>
#include <climits>

namespace striate {

bool say(std::FILE* to, std::string_view text) noexcept {
  const bool whole = std::fwrite(text.data(), 1, text.size(), to) == text.size();
  return std::fflush(to) == 0 && whole;
}

bool say_without_waiting(std::FILE* to, std::string_view text) noexcept {
  pollfd line{fileno(to), POLLOUT, 0};
  if (poll(&line, 1, 0) == 0) return true;
  // So much a pipe takes at once when it can be written at all.
  return say(to, text.substr(0, std::min<std::size_t>(text.size(), PIPE_BUF)));
}

}  // namespace striate
