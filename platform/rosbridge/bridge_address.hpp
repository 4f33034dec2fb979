#pragma once

#include <cstdint>
#include <string>

namespace striate::rosbridge {

/// Where a rosbridge server is.
struct BridgeAddress {
  std::string url;   ///< as it was given, for messages
  std::string host;  ///< a name, or an address in numbers without brackets
  std::uint16_t port = 9090;
  std::string path = "/";
  /// What the handshake calls it: brackets about an address of IPv6, and the port.
  [[nodiscard]] std::string host_field() const;
};

/// ws://host, ws://host:9090, ws://[::1]:9090/path. Without a port 9090, rosbridge's own.
/// @throws UserError for anything else.
[[nodiscard]] BridgeAddress read_bridge_address(const std::string& url);

}  // namespace striate::rosbridge
