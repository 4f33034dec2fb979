#include "striate/viewer/foxglove/access.hpp"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <sys/random.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <stdexcept>

namespace striate::viewer::foxglove {
namespace {

std::string lower_case(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return lower;
}

/// "[::1]:8765" -> "::1", "localhost:8765" -> "localhost". A forwarded port is another one here
/// than there, so the port says nothing. "" for what is neither.
std::string host_without_port(std::string_view host) {
  std::string_view name;
  std::string_view rest;
  if (!host.empty() && host.front() == '[') {
    const std::size_t end = host.find(']');
    if (end == std::string_view::npos) return {};
    name = host.substr(1, end - 1);
    rest = host.substr(end + 1);
  } else {
    const std::size_t colon = std::min(host.find(':'), host.size());
    name = host.substr(0, colon);
    rest = host.substr(colon);
  }
  const bool port_is_number =
      rest.empty() || (rest.size() > 1 && rest[0] == ':' &&
                       rest.find_first_not_of("0123456789", 1) == std::string_view::npos);
  return port_is_number ? lower_case(name) : std::string();
}

bool is_ip_address(const std::string& host) {
  std::array<unsigned char, sizeof(in6_addr)> address{};
  return inet_pton(AF_INET, host.c_str(), address.data()) == 1 ||
         inet_pton(AF_INET6, host.c_str(), address.data()) == 1;
}

bool listens_everywhere(const std::string& address) {
  return address == "0.0.0.0" || address == "::";
}

/// HOST_NAME_MAX of Linux, and the NUL
constexpr std::size_t kHostNameRoom = 65;

bool names_this_machine(const std::string& host) {
  std::array<char, kHostNameRoom> name{};
  if (gethostname(name.data(), name.size() - 1) != 0) return false;
  const std::string own = lower_case(name.data());
  return !own.empty() && (host == own || host == own + ".local");
}

/// A page that had its own name point to this machine comes under that name, so a name must be
/// ours. A number cannot be made to point elsewhere.
bool is_ours(const AccessRules& rules, const std::string& host) {
  if (is_loopback(host) || host == lower_case(rules.listen)) return true;
  return listens_everywhere(rules.listen) && (is_ip_address(host) || names_this_machine(host));
}

bool origin_may(const AccessRules& rules, std::string_view origin) {
  if (origin == "file://") return true;
  const auto& more = rules.more_origins;
  if (std::find(more.begin(), more.end(), origin) != more.end()) return true;
  for (const std::string_view scheme : {"http://", "https://"}) {
    if (origin.substr(0, scheme.size()) == scheme) {
      return is_ours(rules, host_without_port(origin.substr(scheme.size())));
    }
  }
  return false;
}

/// The value of `token` in "/?a=b&token=..."
std::string_view token_in(std::string_view target) {
  constexpr std::string_view kName = "token=";
  std::size_t at = target.find('?');
  while (at != std::string_view::npos) {
    const std::string_view rest = target.substr(at + 1);
    const std::size_t end = rest.find('&');
    if (rest.substr(0, kName.size()) == kName) {
      return rest.substr(0, end).substr(kName.size());
    }
    at = end == std::string_view::npos ? end : at + 1 + end;
  }
  return {};
}

/// Takes as long for one wrong letter as for another.
bool same_token(std::string_view given, std::string_view token) {
  unsigned differs = given.size() == token.size() ? 0U : 1U;
  for (std::size_t k = 0; k < token.size(); ++k) {
    const char c = k < given.size() ? given[k] : '\0';
    differs |= static_cast<unsigned char>(c) ^ static_cast<unsigned char>(token[k]);
  }
  return differs == 0;
}

}  // namespace

bool is_loopback(std::string_view host) {
  const std::string name = lower_case(host);
  if (name == "localhost" || name == "::1") return true;
  in_addr address{};
  return inet_pton(AF_INET, name.c_str(), &address) == 1 && ntohl(address.s_addr) >> 24U == 127U;
}

std::string why_refused(const AccessRules& rules, const Handshake& handshake) {
  if (!is_ours(rules, host_without_port(handshake.host))) {
    return fmt::format("the host '{}' is not the address of this robot", handshake.host);
  }
  if (!handshake.origin.empty() && !origin_may(rules, handshake.origin)) {
    return fmt::format(
        "pages of '{}' may not look at this robot; 'striate' lets them with --allow-origin",
        handshake.origin);
  }
  if (!rules.token.empty() && !same_token(token_in(handshake.target), rules.token)) {
    return "the address needs ?token=..., as 'striate' has printed it";
  }
  return {};
}

std::string new_token() {
  std::array<unsigned char, 16> bytes{};
  if (getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size())) {
    throw std::runtime_error("the system gives no random numbers for a token");
  }
  std::string token;
  for (const unsigned char byte : bytes) token += fmt::format("{:02x}", byte);
  return token;
}

}  // namespace striate::viewer::foxglove
