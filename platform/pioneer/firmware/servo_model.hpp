#pragma once

#include <array>
#include <optional>

#include "striate/base/bytes.hpp"
#include "striate/platform/pioneer/turret/dynamixel.hpp"

namespace striate::pioneer {

/// One AX-12A as it behaves on the bus: its control table with limits, the instructions of
/// Dynamixel protocol 1.0, speed, and the overload that switches it off.
class ServoModel {
 public:
  ServoModel(std::uint8_t id, double angle_rad);

  void step(double dt_s);
  [[nodiscard]] std::uint8_t id() const { return registers_[dynamixel::Register::id]; }
  [[nodiscard]] double angle_rad() const { return angle_rad_; }
  [[nodiscard]] double speed_rad_s() const { return speed_rad_s_; }
  /// What is wrong with it now: dynamixel::Error bits of every reply.
  [[nodiscard]] std::uint8_t errors() const { return errors_; }

  bool blocked = false;   ///< something holds it
  bool connected = true;  ///< false: its plug has come off

  /// Does what a packet says. The reply, without parameters but to READ; nothing: its status
  /// return level keeps it silent. A refused instruction changes nothing.
  std::optional<dynamixel::Packet> obey(const dynamixel::Packet& packet);
  /// A packet for it came with a wrong sum.
  [[nodiscard]] std::optional<dynamixel::Packet> refuse_sum() const;
  /// @returns dynamixel::Error bits; 0: written
  std::uint8_t write(std::uint8_t address, ByteView values);

 private:
  void set_to_factory(std::uint8_t id);
  [[nodiscard]] std::uint8_t check(std::uint8_t address, ByteView values) const;
  std::uint8_t read_into(dynamixel::Packet& reply, ByteView parameters) const;
  std::uint8_t register_write(ByteView parameters);
  std::uint8_t act();
  [[nodiscard]] bool has_no_limits() const;
  [[nodiscard]] double wanted_rad(double dt_s) const;
  void watch_limits(bool pushes, double dt_s);
  void tell();
  [[nodiscard]] std::uint16_t word(std::uint8_t address) const;
  void set_word(std::uint8_t address, std::uint16_t value);

  std::array<std::uint8_t, 50> registers_{};
  Bytes registered_;  ///< address and values of a REG_WRITE that waits for ACTION
  double angle_rad_;
  double speed_rad_s_ = 0.0;
  double pushing_s_ = 0.0;
  bool overloaded_ = false;
  std::uint8_t errors_ = 0;
};

}  // namespace striate::pioneer
