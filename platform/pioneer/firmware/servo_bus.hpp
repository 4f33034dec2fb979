#pragma once

#include <array>
#include <vector>

#include "striate/base/time.hpp"
#include "striate/platform/pioneer/turret/dynamixel.hpp"

namespace striate::pioneer {

/// One AX-12A as it behaves on the bus: registers, speed, and the overload that switches it off.
class ServoModel {
 public:
  ServoModel(std::uint8_t id, double angle_rad);

  void step(double dt_s);
  [[nodiscard]] std::uint8_t id() const { return registers_[dynamixel::Register::id]; }
  [[nodiscard]] double angle_rad() const { return angle_rad_; }
  [[nodiscard]] double speed_rad_s() const { return speed_rad_s_; }
  [[nodiscard]] std::uint8_t errors() const { return errors_; }

  bool blocked = false;   ///< something holds it
  bool connected = true;  ///< false: its plug has come off

  [[nodiscard]] Bytes read(std::uint8_t address, std::size_t count) const;
  void write(std::uint8_t address, ByteView values);

 private:
  [[nodiscard]] std::uint16_t word(std::uint8_t address) const;
  void set_word(std::uint8_t address, std::uint16_t value);

  std::array<std::uint8_t, 50> registers_{};
  double angle_rad_;
  double speed_rad_s_ = 0.0;
  double pushing_s_ = 0.0;
  std::uint8_t errors_ = 0;
};

/// Servos on one half-duplex line: takes instructions, gives replies.
class ServoBus {
 public:
  explicit ServoBus(std::vector<ServoModel> on_the_line) : servos(std::move(on_the_line)) {}
  void receive(ByteView bytes);
  void step(Duration step);
  [[nodiscard]] Bytes take_output();

  std::vector<ServoModel> servos;

 private:
  void obey(const dynamixel::Packet& packet);
  void write_all(const dynamixel::Packet& packet);
  dynamixel::PacketStream stream_;
  Bytes output_;
};

}  // namespace striate::pioneer
