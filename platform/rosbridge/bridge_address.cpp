#include "striate/platform/rosbridge/bridge_address.hpp"

#include <fmt/format.h>

#include <charconv>
#include <string_view>

#include "striate/base/plain_text.hpp"
#include "striate/base/user_error.hpp"

namespace striate::rosbridge {
namespace {

constexpr std::string_view kScheme = "ws://";
constexpr const char* kExample = "ws://turtlebot:9090";

[[noreturn]] void refuse_address(const std::string& url, std::string_view why,
                                 std::string_view hint = {}) {
  throw UserError(fmt::format("rosbridge.url '{}': {}\n  hint: {}", plain_text(url), why,
                              hint.empty() ? kExample : hint));
}

std::uint16_t port_in(const std::string& url, std::string_view text) {
  unsigned port = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), port);
  const bool all = error == std::errc() && end == text.data() + text.size();
  if (!all || port < 1 || port > 65535) refuse_address(url, "the port must be 1 .. 65535");
  return static_cast<std::uint16_t>(port);
}

/// Letters that end nothing in a line of HTTP.
bool is_for_http(std::string_view text) {
  for (const char letter : text) {
    if (letter <= ' ' || letter > '~') return false;
  }
  return true;
}

}  // namespace

std::string BridgeAddress::host_field() const {
  const bool is_v6 = host.find(':') != std::string::npos;
  return fmt::format("{}{}{}:{}", is_v6 ? "[" : "", host, is_v6 ? "]" : "",
                     static_cast<unsigned>(port));
}

BridgeAddress read_bridge_address(const std::string& url) {
  if (url.starts_with("wss://")) {
    refuse_address(url, "encrypted lines are not spoken",
                   "let a tunnel encrypt it, as ssh -L 9090:localhost:9090 robot, and write "
                   "ws://localhost:9090");
  }
  if (!url.starts_with(kScheme)) refuse_address(url, "must begin with ws://");
  if (!is_for_http(url)) refuse_address(url, "has letters that no address has");
  std::string_view rest = std::string_view(url).substr(kScheme.size());
  BridgeAddress address;
  address.url = url;
  const std::size_t slash = std::min(rest.find_first_of("/?"), rest.size());
  if (slash < rest.size()) {
    address.path = (rest[slash] == '?' ? "/" : "") + std::string(rest.substr(slash));
  }
  rest = rest.substr(0, slash);
  if (rest.find('@') != std::string_view::npos) refuse_address(url, "names no user");
  std::size_t host_end = rest.rfind(':');
  if (rest.starts_with('[')) {
    const std::size_t bracket = rest.find(']');
    if (bracket == std::string_view::npos) refuse_address(url, "a ']' is missing");
    address.host = rest.substr(1, bracket - 1);
    host_end = bracket + 1 < rest.size() ? bracket + 1 : std::string_view::npos;
    if (host_end != std::string_view::npos && rest[host_end] != ':') {
      refuse_address(url, "behind ']' only a port may stand");
    }
  } else {
    address.host = rest.substr(0, host_end);
  }
  if (host_end != std::string_view::npos) address.port = port_in(url, rest.substr(host_end + 1));
  if (address.host.empty()) refuse_address(url, "the host is missing");
  return address;
}

}  // namespace striate::rosbridge
