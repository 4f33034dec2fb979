#pragma once

#include <memory>
#include <string>

#include "striate/base/bytes.hpp"
#include "striate/base/time.hpp"

namespace striate::pioneer {

/// A line to a device: serial, TCP, or memory. Nothing here blocks longer than `wait` allows, so
/// that no device can hold up the safety gate.
class Transport {
 public:
  virtual ~Transport() = default;
  /// Begins to open; `is_open` tells when that is done.
  virtual void open() = 0;
  virtual void close() = 0;
  /// Opening has begun and has neither succeeded nor failed.
  [[nodiscard]] virtual bool is_opening() const = 0;
  [[nodiscard]] virtual bool is_open() const = 0;
  /// What has come since the last call.
  [[nodiscard]] virtual Bytes read() = 0;
  /// Takes bytes for sending. A line that takes nothing for too long is closed.
  virtual void write(ByteView bytes) = 0;
  /// Waits for something to read, or for so long.
  virtual void wait(Duration at_most) = 0;
  /// Why it is not open, in plain words.
  [[nodiscard]] virtual std::string trouble() const { return {}; }
};

/// serial:/dev/ttyUSB0?baud=38400, tcp://host:8101 (the port may be left out), pty:/dev/pts/3.
/// @throws UserError for any other text.
[[nodiscard]] std::unique_ptr<Transport> make_transport(const std::string& url);
/// The same for what moves: a process of its own holds the line and stops the robot when this one
/// dies, see keeper/kept_line.hpp.
[[nodiscard]] std::unique_ptr<Transport> make_kept_transport(const std::string& url);

}  // namespace striate::pioneer
