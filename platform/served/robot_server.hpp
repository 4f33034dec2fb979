#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <string>

#include "striate/platform/served/line_faults.hpp"
#include "striate/platform/served/served_line.hpp"
#include "striate/platform/served/served_pioneer.hpp"
#include "striate/platform/simulator/image_source.hpp"

namespace striate::served {

/// What breaks on purpose besides the base's line. Times count from the base's connection; 0:
/// never.
struct DeviceFaults {
  double laser_silent_at_s = 0.0;
  double turret_sticks_at_s = 0.0;
};

struct ServeSettings {
  std::string address = "127.0.0.1";
  /// Of the base; turret, laser and camera have the next three. 0: any free ones.
  int port = 8101;
  bool pty = false;     ///< base, turret and laser on pseudo-terminals instead of TCP
  LineFaults faults{};  ///< of the base's line
  DeviceFaults devices{};
  std::uint64_t seed = 1;         ///< of the faults
  double camera_latency_s = 0.0;  ///< from light to the image's packet, at least
  /// So long a client may say nothing that its device understands, see ServedLine
  std::chrono::milliseconds idle_limit = ServedPlace{}.idle_limit;
};

/// The truth about the served robot, from any thread.
struct ServedState {
  double time_s = 0.0;
  double connected_s = 0.0;  ///< since the base's newest client came
  Pose2 true_pose;
  double true_forward_m_s = 0.0;
  HeadPose true_head;
  bool connected = false;  ///< a client's session is open
  bool commanded_to_stand = true;
  bool motors_on = false;
  std::size_t collisions = 0;
  bool beyond_goal = false;  ///< of the world
};

/// What a driver connects to: "tcp://127.0.0.1:8101" or "pty:/dev/pts/3".
struct ServedUrls {
  std::string base;
  std::string turret;
  std::string laser;
  std::string camera;  ///< always TCP; empty: there is no camera
};

/// Serves a simulated Pioneer in real time, base, turret, laser and camera each to one client at a
/// time. A client that vanishes is, as on a real robot, only silence: the watchdog stops the
/// wheels.
class RobotServer {
 public:
  using Log = std::function<void(const std::string&)>;

  /// Listens from now on. `images` may be null: then there is no camera; it must outlive this,
  /// and nobody else may use it.
  /// @throws std::runtime_error when a place cannot be had.
  RobotServer(ServedPioneer& robot, simulator::ImageSource* pictures, const ServeSettings& settings,
              Log log);
  ~RobotServer();

  [[nodiscard]] const ServedUrls& urls() const;
  /// Serves in real time until this says false.
  void run(const std::function<bool()>& goes_on);
  [[nodiscard]] ServedState state() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace striate::served
