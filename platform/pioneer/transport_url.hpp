#pragma once

#include <string>

namespace striate::pioneer {

/// Where a robot's line is.
struct TransportUrl {
  enum class Kind { tcp, serial };
  Kind kind = Kind::tcp;
  std::string host;    ///< tcp
  int port = 8101;     ///< tcp; one robot a port
  std::string device;  ///< serial, also a pseudo-terminal
  int baud = 9600;     ///< serial; real robots begin at 9600
};

/// tcp://host, tcp://host:8102, serial:/dev/ttyUSB0, serial:/dev/ttyUSB0?baud=38400, pty:/dev/pts/3
/// @throws UserError for anything else.
[[nodiscard]] TransportUrl parse_transport_url(const std::string& text);

}  // namespace striate::pioneer
