#pragma once

#include <boost/asio/io_context.hpp>
#include <chrono>
#include <cstdint>
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
  /// So long a client may say nothing. ARIA takes a robot for lost after 8 s without a packet.
  std::chrono::milliseconds idle_limit{8000};
  /// More than so much waiting: the client does not read, and is let go.
  std::size_t most_waiting = 1 << 16;
};

/// How its client and a device get on.
struct Dealings {
  std::uint64_t understood = 0;  ///< words of the client's, all that ever came
  bool streams = false;          ///< the device sends by itself what was asked for
};

/// A TCP port or a pseudo-terminal that one client at a time may use; one more may wait. A client
/// that says nothing to which the device streams nothing is let go: at once where it never said a
/// word, else where somebody waits; and one that does not read what comes. Everything happens in
/// the thread that runs `io`.
class ServedLine {
 public:
  struct Events {
    std::function<void()> connected;
    std::function<void(ByteView)> received;
    std::function<void(const std::string&)> log;
    std::function<Dealings()> dealings;
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
  /// Looks for clients that hold the line for nothing; call several times a second.
  void tend();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace striate::served
