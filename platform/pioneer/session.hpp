#pragma once

#include <optional>
#include <string>

#include "striate/platform/pioneer/arcos/command.hpp"
#include "striate/platform/pioneer/arcos/other_packets.hpp"
#include "striate/platform/pioneer/arcos/packet_stream.hpp"
#include "striate/platform/pioneer/base_state.hpp"
#include "striate/platform/pioneer/round_trip.hpp"
#include "striate/platform/pioneer/session_settings.hpp"

namespace striate::pioneer {

enum class LinkState {
  waiting,      ///< for the line, or backing off before it is opened anew
  syncing,      ///< SYNC0, SYNC1, SYNC2
  opening,      ///< OPEN and a stop are sent, no packet yet
  configuring,  ///< CONFIG is sent
  ready,
  closed,   ///< by us
  refused,  ///< the robot is of an unknown kind
};
[[nodiscard]] const char* name_of(LinkState state);

/// What the line did since the start.
struct LinkCounters {
  arcos::StreamCounters stream;
  std::uint64_t malformed = 0;  ///< good checksum, payload too short for its kind
  std::uint64_t unknown = 0;    ///< ids that mean nothing here; ignored
  std::uint64_t sips = 0;
  std::uint64_t connections = 0;  ///< times the session got ready
  int last_malformed_id = -1;
  int last_unknown_id = -1;
};

/// The program's side of an ARCOS connection: handshake, configuration, life signs, reconnection.
/// Pure: bytes and times go in, bytes come out; no clock, no thread, no device. Motion is sent by
/// the SafetyGate alone.
class ArcosSession {
 public:
  explicit ArcosSession(const SessionSettings& settings) : settings_(settings) {}

  /// The transport should be open now. False: leave it closed, or close it.
  [[nodiscard]] bool wants_line(TimePoint now) const;
  void line_up(TimePoint now);
  void line_down(TimePoint now);

  void receive(ByteView bytes, TimePoint now);
  /// Call every few 10 ms.
  void tick(TimePoint now);
  /// Says good-bye; `take_output` still has to be sent.
  void close();
  /// Bytes for the robot, in order.
  [[nodiscard]] Bytes take_output();

  [[nodiscard]] LinkState state() const { return state_; }
  [[nodiscard]] const BaseState& base() const { return tracker_.state(); }
  [[nodiscard]] const arcos::RobotNames& names() const { return names_; }
  [[nodiscard]] const std::optional<arcos::ConfigPac>& config() const { return config_; }
  [[nodiscard]] const RobotModel& model() const { return model_; }
  [[nodiscard]] const std::optional<arcos::SimStat>& true_pose() const { return true_pose_; }
  [[nodiscard]] LinkCounters counters() const;
  /// First byte of the newest good packet; the start of the connection before any came.
  [[nodiscard]] TimePoint last_packet() const { return last_packet_; }
  /// In plain words what is wrong, empty when nothing is.
  [[nodiscard]] const std::string& trouble() const { return trouble_; }
  /// What may be sent at most: settings, the robot's own limits, its kind's.
  [[nodiscard]] double most_forward_mm_s() const;
  [[nodiscard]] double most_turn_deg_s() const;
  /// With which the robot was told to slow down.
  [[nodiscard]] double deceleration_mm_s2() const;
  /// When the robot last told its own state; the start of the connection before it did.
  [[nodiscard]] TimePoint last_state() const;
  /// How late the line is, there and back; see RoundTrip. Nothing: not known yet.
  [[nodiscard]] std::optional<Duration> line_delay(TimePoint now) const {
    return round_trip_.delay(now);
  }
  /// Whether `line_delay` can be known.
  [[nodiscard]] bool measures_the_line() const { return settings_.echo; }
  /// Asks a simulated robot for its true pose.
  void ask_true_pose();

 private:
  friend class SafetyGate;
  /// Only the gate moves the robot.
  void send(const Bytes& bytes) { append(output_, bytes); }

  void handle(const arcos::Packet& packet, TimePoint now);
  void handle_syncing(const arcos::Packet& packet, TimePoint now);
  void handle_open(const arcos::Packet& packet, TimePoint now);
  void take_sip(const arcos::Packet& packet, TimePoint now);
  void begin_sync(TimePoint now);
  void send_sync(TimePoint now);
  void sync_again(TimePoint now);
  void tick_syncing(TimePoint now);
  void meet(const arcos::RobotNames& names, TimePoint now);
  void get_ready(TimePoint now);
  void tell_limits();
  void ask_for_laser();
  void ask_for_config(TimePoint now);
  void measure_the_line(TimePoint now);
  void lose(TimePoint now, const std::string& why);

  SessionSettings settings_;
  LinkState state_ = LinkState::waiting;
  arcos::PacketStream stream_;
  BaseTracker tracker_;
  arcos::SimLaserSweep sweep_;
  RoundTrip round_trip_;
  RobotModel model_;
  arcos::RobotNames names_;
  std::optional<arcos::ConfigPac> config_;
  std::optional<arcos::SimStat> true_pose_;
  Bytes output_;
  LinkCounters counters_;
  std::string trouble_;

  bool line_is_up_ = false;
  int sync_step_ = 0;  ///< -1: listens, or waits for an older connection to end
  bool closing_old_ = false;
  int silent_syncs_ = 0;
  int restarts_ = 0;
  TimePoint state_since_;
  TimePoint sent_at_;  ///< the last step of handshake or configuration
  TimePoint last_packet_;
  TimePoint incomplete_since_;
  bool incomplete_ = false;
  TimePoint open_again_at_;
  double back_off_s_ = 0.0;
};

}  // namespace striate::pioneer
