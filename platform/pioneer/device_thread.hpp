#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <thread>

#include "striate/platform/pioneer/mailbox.hpp"
#include "striate/platform/pioneer/transport.hpp"

namespace striate::pioneer {

/// A device at the end of a line, as its thread sees it: bytes and times go in, bytes come out, and
/// what has changed is put into mailboxes.
class Device {
 public:
  virtual ~Device() = default;
  /// The line is open, from its beginning.
  virtual void line_up(TimePoint /*now*/) {}
  virtual void receive(ByteView bytes, TimePoint now) = 0;
  virtual void tick(TimePoint now) = 0;
  [[nodiscard]] virtual Bytes take_output() { return {}; }
  /// Says good-bye; `take_output` is sent once more.
  virtual void close() {}
};

/// Gives a device its line and a thread of its own. A line that breaks is opened anew with back-off
/// as long as this lives.
class DeviceThread {
 public:
  /// `device` and `clock` must outlive this.
  DeviceThread(Device& device, std::unique_ptr<Transport> line, const Clock& clock);
  ~DeviceThread();
  DeviceThread(const DeviceThread&) = delete;
  DeviceThread& operator=(const DeviceThread&) = delete;

  /// Why the line is not open, in plain words; empty: it is.
  [[nodiscard]] std::string trouble() const { return trouble_.newest(); }

 private:
  void run();
  void begin_anew(const char* why) noexcept;
  void care_for_the_line(TimePoint now);
  void send(const Bytes& bytes);

  Device& device_;
  std::unique_ptr<Transport> line_;
  const Clock& clock_;
  Mailbox<std::string> trouble_;
  bool was_open_ = false;
  TimePoint open_again_at_;
  double back_off_s_ = 0.0;
  std::atomic<bool> ends_{false};
  std::thread thread_;  // last: it uses all of the above
};

}  // namespace striate::pioneer
