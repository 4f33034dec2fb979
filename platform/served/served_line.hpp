#pragma once

#include <boost/asio/io_context.hpp>
#include <functional>
#include <memory>
#include <string>

#include "striate/base/bytes.hpp"

namespace striate::served {

/// Where a served device can be found.
struct ServedPlace {
  std::string name;  ///< "base", "laser": for the log
  std::string address = "127.0.0.1";
  int port = 0;      ///< 0: any free one
  bool pty = false;  ///< a pseudo-terminal instead of TCP
  /// More than so much waiting: the client does not read, and is let go.
  std::size_t most_waiting = 1 << 16;
};

/// A TCP port or a pseudo-terminal that one client at a time may use. Everything happens in the
/// thread that runs `io`.
class ServedLine {
 public:
  struct Events {
    std::function<void()> connected;
    std::function<void(ByteView)> received;
    std::function<void(const std::string&)> log;
  };

  /// Listens from now on. @throws std::runtime_error when the place cannot be had.
  ServedLine(boost::asio::io_context& io, ServedPlace place, Events events);
  ~ServedLine();

  /// "tcp://127.0.0.1:8101" or "pty:/dev/pts/3": what a driver connects to.
  [[nodiscard]] const std::string& url() const;
  [[nodiscard]] bool has_client() const;
  /// Nothing of what was written is still waiting.
  [[nodiscard]] bool idle() const;
  /// For the client; dropped where there is none.
  void write(Bytes bytes);
  /// Ends the connection; a pseudo-terminal has none to end.
  void let_go(const std::string& why);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace striate::served
