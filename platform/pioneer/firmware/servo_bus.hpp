#pragma once

#include <vector>

#include "striate/base/time.hpp"
#include "striate/platform/pioneer/firmware/servo_model.hpp"

namespace striate::pioneer {

/// Servos on one half-duplex line: takes instructions, gives replies.
class ServoBus {
 public:
  explicit ServoBus(std::vector<ServoModel> on_the_line) : servos(std::move(on_the_line)) {}
  void receive(ByteView bytes);
  void step(Duration step);
  [[nodiscard]] Bytes take_output();
  /// Whole instructions that have come so far.
  [[nodiscard]] std::uint64_t understood() const { return stream_.counters().packets; }

  std::vector<ServoModel> servos;

 private:
  void obey_all();
  void obey(const dynamixel::Packet& packet);
  void write_all(const dynamixel::Packet& packet);
  void answer(const std::optional<dynamixel::Packet>& reply);
  dynamixel::PacketStream stream_;
  Bytes output_;
  Duration waited_{};  ///< for the rest of a packet
};

}  // namespace striate::pioneer
