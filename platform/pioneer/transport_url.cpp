#include "striate/platform/pioneer/transport_url.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>

#include "striate/base/user_error.hpp"

namespace striate::pioneer {
namespace {

constexpr std::array kBauds{9600, 19200, 38400, 57600, 115200};  // ARCOS manual, HOSTBAUD 0 .. 4

[[noreturn]] void refuse(const std::string& text, const std::string& why) {
  throw UserError(fmt::format(
      "'{}': {}\n  hint: tcp://host:8101, serial:/dev/ttyUSB0?baud=38400 or pty:/dev/pts/3", text,
      why));
}

/// -1: no number.
int number(const std::string& text) {
  int value = -1;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() ? value : -1;
}

TransportUrl parse_tcp(const std::string& text, const std::string& rest) {
  TransportUrl url;
  const std::size_t colon = rest.rfind(':');
  url.host = rest.substr(0, colon);
  if (colon != std::string::npos) url.port = number(rest.substr(colon + 1));
  if (url.host.empty()) refuse(text, "the host is missing");
  if (url.port < 1 || url.port > 65535) refuse(text, "the port must be 1 .. 65535");
  return url;
}

TransportUrl parse_serial(const std::string& text, const std::string& rest) {
  TransportUrl url;
  url.kind = TransportUrl::Kind::serial;
  const std::size_t question = rest.find('?');
  url.device = rest.substr(0, question);
  if (url.device.empty() || url.device[0] != '/') refuse(text, "the device must begin with '/'");
  if (question == std::string::npos) return url;
  const std::string option = rest.substr(question + 1);
  if (option.rfind("baud=", 0) != 0) refuse(text, "after '?' only 'baud=' is known");
  url.baud = number(option.substr(5));
  if (std::find(kBauds.begin(), kBauds.end(), url.baud) == kBauds.end()) {
    refuse(text, "baud must be 9600, 19200, 38400, 57600 or 115200");
  }
  return url;
}

}  // namespace

TransportUrl parse_transport_url(const std::string& text) {
  const auto behind = [&](const char* prefix) -> std::string {
    return text.rfind(prefix, 0) == 0 ? text.substr(std::string(prefix).size()) : std::string();
  };
  if (const std::string rest = behind("tcp://"); !rest.empty()) return parse_tcp(text, rest);
  if (const std::string rest = behind("serial:"); !rest.empty()) return parse_serial(text, rest);
  if (const std::string rest = behind("pty:"); !rest.empty()) return parse_serial(text, rest);
  refuse(text, "is no place of a robot");
}

}  // namespace striate::pioneer
