#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <string>

#include "app/serving/line_faults.hpp"
#include "app/serving/served_pioneer.hpp"

namespace striate {

struct ServeSettings {
  std::string address = "127.0.0.1";
  int port = 8101;   ///< 0: any free one
  bool pty = false;  ///< a pseudo-terminal instead of TCP
  LineFaults faults{};
  std::uint64_t seed = 1;  ///< of the faults
};

/// The truth about the served robot, from any thread.
struct ServedState {
  double time_s = 0.0;
  Pose2 true_pose;
  double true_forward_m_s = 0.0;
  bool connected = false;  ///< a client's session is open
  bool commanded_to_stand = true;
  bool motors_on = false;
};

/// Serves a simulated Pioneer in real time to one client at a time, over TCP or a pseudo-terminal.
/// A client that vanishes is, as on a real robot, only silence: the watchdog stops the wheels.
class ArcosServer {
 public:
  using Log = std::function<void(const std::string&)>;

  /// Listens from now on. @throws std::runtime_error when the address cannot be had.
  ArcosServer(ServedPioneer& robot, const ServeSettings& settings, Log log);
  ~ArcosServer();

  /// "tcp://127.0.0.1:8101" or "pty:/dev/pts/3": what a driver connects to.
  [[nodiscard]] const std::string& url() const;
  /// Serves in real time until this says false.
  void run(const std::function<bool()>& goes_on);
  [[nodiscard]] ServedState state() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace striate
