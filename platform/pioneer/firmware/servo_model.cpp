#include "striate/platform/pioneer/firmware/servo_model.hpp"

#include <algorithm>

namespace striate::pioneer {

using dynamixel::Error;
using dynamixel::Instruction;
using dynamixel::Register;

ServoModel::ServoModel(std::uint8_t id, double angle_rad) : angle_rad_(angle_rad) {
  set_to_factory(id);
}

std::uint8_t ServoModel::write(std::uint8_t address, ByteView values) {
  if (const std::uint8_t error = check(address, values); error != 0) return error;
  std::copy(values.begin(), values.end(), registers_.begin() + address);
  const auto wrote = [&](std::uint8_t place) {
    return address <= place && place < address + values.size();
  };
  if (wrote(Register::goal_position)) registers_[Register::torque_enable] = 1;
  if (wrote(Register::torque_limit) && word(Register::torque_limit) > 0) {
    overloaded_ = false;
    pushing_s_ = 0.0;
    set_word(Register::goal_position, dynamixel::ticks_of(angle_rad_));
    watch_limits(false, 0.0);
  }
  return 0;
}

std::uint8_t ServoModel::read_into(dynamixel::Packet& reply, ByteView parameters) const {
  if (parameters.size() != 2) return Error::instruction;
  const std::size_t address = parameters[0];
  const std::size_t count = parameters[1];
  if (count == 0 || address + count > registers_.size()) return Error::range;
  const auto first = registers_.begin() + static_cast<std::ptrdiff_t>(address);
  reply.parameters.assign(first, first + static_cast<std::ptrdiff_t>(count));
  return 0;
}

std::uint8_t ServoModel::register_write(ByteView parameters) {
  if (parameters.size() < 2) return Error::instruction;
  if (const std::uint8_t error = check(parameters[0], parameters.subspan(1)); error != 0) {
    return error;
  }
  registered_.assign(parameters.begin(), parameters.end());
  registers_[Register::registered] = 1;
  return 0;
}

std::uint8_t ServoModel::act() {
  if (registered_.empty()) return Error::instruction;
  const Bytes registered = std::exchange(registered_, {});
  registers_[Register::registered] = 0;
  return write(registered[0], ByteView(registered).subspan(1));
}

std::optional<dynamixel::Packet> ServoModel::obey(const dynamixel::Packet& packet) {
  const ByteView parameters = packet.parameters;
  dynamixel::Packet reply{id(), 0, {}};
  std::uint8_t error = 0;
  int silent_below = 2;  // status return level
  switch (static_cast<Instruction>(packet.code)) {
    case Instruction::ping:
      silent_below = 0;
      break;
    case Instruction::read:
      silent_below = 1;
      error = read_into(reply, parameters);
      break;
    case Instruction::write:
      error = parameters.size() < 2 ? static_cast<std::uint8_t>(Error::instruction)
                                    : write(parameters[0], parameters.subspan(1));
      break;
    case Instruction::register_write:
      error = register_write(parameters);
      break;
    case Instruction::action:
      error = act();
      break;
    case Instruction::reset:
      set_to_factory(1);  // the id of a servo from the factory
      break;
    case Instruction::sync_write:  // for all or for none
    default:
      error = Error::instruction;
  }
  if (registers_[Register::status_level] < silent_below) return std::nullopt;
  reply.code = static_cast<std::uint8_t>(errors_ | error);
  return reply;
}

std::optional<dynamixel::Packet> ServoModel::refuse_sum() const {
  if (registers_[Register::status_level] < 2) return std::nullopt;
  return dynamixel::Packet{id(), static_cast<std::uint8_t>(errors_ | Error::checksum), {}};
}

}  // namespace striate::pioneer
