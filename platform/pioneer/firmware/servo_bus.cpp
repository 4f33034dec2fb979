#include "striate/platform/pioneer/firmware/servo_bus.hpp"

namespace striate::pioneer {

using dynamixel::Instruction;

namespace {

/// Half a packet that stays so is none: six times what the longest one takes at 115200 baud, 22 ms,
/// as some programs write byte by byte (ours)
constexpr Duration kMostBetweenBytes = std::chrono::milliseconds(130);

}  // namespace

void ServoBus::receive(ByteView bytes) {
  if (!bytes.empty()) waited_ = {};
  stream_.push(bytes);
  obey_all();
}

void ServoBus::obey_all() {
  while (true) {
    const auto packet = stream_.next();
    // Sums that were wrong lie before the packet.
    for (const std::uint8_t id : stream_.take_bad_sums()) {
      for (const ServoModel& servo : servos) {
        if (servo.connected && servo.id() == id) answer(servo.refuse_sum());
      }
    }
    if (!packet) return;
    obey(*packet);
  }
}

void ServoBus::step(Duration step) {
  waited_ += step;
  while (stream_.waiting() && waited_ > kMostBetweenBytes) {
    stream_.give_up_waiting();
    obey_all();
  }
  for (ServoModel& servo : servos) servo.step(to_seconds(step));
}

Bytes ServoBus::take_output() {
  Bytes bytes;
  bytes.swap(output_);
  return bytes;
}

void ServoBus::answer(const std::optional<dynamixel::Packet>& reply) {
  if (reply) append(output_, dynamixel::encode(*reply));
}

void ServoBus::write_all(const dynamixel::Packet& packet) {
  if (packet.parameters.size() < 2) return;
  const std::size_t size = packet.parameters[1];
  ByteView left = ByteView(packet.parameters).subspan(2);
  while (left.size() >= size + 1) {
    for (ServoModel& servo : servos) {
      if (servo.connected && servo.id() == left[0]) {
        (void)servo.write(packet.parameters[0], left.subspan(1, size));
      }
    }
    left = left.subspan(size + 1);
  }
}

void ServoBus::obey(const dynamixel::Packet& packet) {
  const bool all = packet.id == dynamixel::kBroadcast;
  if (all && static_cast<Instruction>(packet.code) == Instruction::sync_write) {
    write_all(packet);
    return;
  }
  // By the ids that they had when it came: it may change them.
  std::vector<ServoModel*> meant;
  for (ServoModel& servo : servos) {
    if (servo.connected && (all || servo.id() == packet.id)) meant.push_back(&servo);
  }
  for (ServoModel* servo : meant) {
    const auto reply = servo->obey(packet);
    if (!all) answer(reply);  // to what is for all, none replies
  }
}

}  // namespace striate::pioneer
