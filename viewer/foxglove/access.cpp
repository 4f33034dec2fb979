#include "striate/viewer/foxglove/access.hpp"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <sys/random.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <stdexcept>

#include "striate/base/lower_case.hpp"

namespace striate::viewer::foxglove {
namespace {

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

/// The page that this very address has given: a forwarded port is the same one in both.
bool is_own_page(const Handshake& handshake) {
  for (const std::string_view scheme : {"http://", "https://"}) {
    if (handshake.origin.substr(0, scheme.size()) == scheme &&
        lower_case(handshake.origin.substr(scheme.size())) == lower_case(handshake.host)) {
      return true;
    }
  }
  return false;
}

bool is_named(const AccessRules& rules, std::string_view origin) {
  const auto& more = rules.more_origins;
  return std::find(more.begin(), more.end(), origin) != more.end();
}

/// Cookies are of a host, whatever the port: each robot's has a name of its own.
std::string cookie_name(const AccessRules& rules) {
  return fmt::format("striate_{}", static_cast<unsigned>(rules.port));
}

/// The value of a cookie in "a=b; striate_8780=..."
std::string_view cookie_value(std::string_view cookies, const std::string& name) {
  while (!cookies.empty()) {
    const std::size_t end = std::min(cookies.find(';'), cookies.size());
    std::string_view one = cookies.substr(0, end);
    one.remove_prefix(std::min(one.find_first_not_of(' '), one.size()));
    if (one.size() > name.size() && one.substr(0, name.size()) == name && one[name.size()] == '=') {
      return one.substr(name.size() + 1);
    }
    cookies.remove_prefix(std::min(end + 1, cookies.size()));
  }
  return {};
}

/// The address has it, or the cookie; a cookie comes along with what other pages ask for, too.
bool knows_token(const AccessRules& rules, const Handshake& handshake) {
  if (rules.token.empty() || same_token(token_in(handshake.target), rules.token)) return true;
  const bool from_us = handshake.origin.empty() || is_own_page(handshake);
  return from_us && same_token(cookie_value(handshake.cookie, cookie_name(rules)), rules.token);
}

constexpr const char* kTokenMissing = "the address needs ?token=..., as 'striate' has printed it";

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
  const bool page_may = handshake.origin.empty() || is_own_page(handshake) ||
                        is_named(rules, handshake.origin) ||
                        (rules.others && origin_may(rules, handshake.origin));
  if (!page_may) {
    return fmt::format(
        "pages of '{}' may not look at this robot; 'striate' lets them with --allow-origin",
        handshake.origin);
  }
  return knows_token(rules, handshake) ? "" : kTokenMissing;
}

std::string why_page_refused(const AccessRules& rules, const Handshake& handshake) {
  if (!is_ours(rules, host_without_port(handshake.host))) {
    return fmt::format("the host '{}' is not the address of this robot", handshake.host);
  }
  const std::string_view path = handshake.target.substr(0, handshake.target.find('?'));
  const bool asked_by_us = handshake.fetch_site.empty() || handshake.fetch_site == "same-origin" ||
                           handshake.fetch_site == "none";
  if (!(handshake.origin.empty() || is_own_page(handshake)) || (!asked_by_us && path != "/")) {
    return "only the dashboard's own page may ask this robot";
  }
  return knows_token(rules, handshake) ? "" : kTokenMissing;
}

std::string cookie_for(const AccessRules& rules, const Handshake& handshake) {
  if (rules.token.empty() || !same_token(token_in(handshake.target), rules.token)) return {};
  return fmt::format("{}={}; Path=/; HttpOnly; SameSite=Strict", cookie_name(rules), rules.token);
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
