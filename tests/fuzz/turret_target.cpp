#include "striate/platform/pioneer/firmware/servo_bus.hpp"
#include "striate/platform/pioneer/turret/arbotix.hpp"
#include "striate/platform/pioneer/turret/dynamixel.hpp"
#include "tests/fuzz/fuzz_target.hpp"

using namespace striate;
using namespace striate::pioneer;

namespace {

std::vector<dynamixel::Packet> packets(ByteView bytes, std::size_t chunk) {
  dynamixel::PacketStream stream;
  std::vector<dynamixel::Packet> all;
  for (std::size_t at = 0; at < bytes.size(); at += chunk) {
    stream.push(bytes.subspan(at, std::min(chunk, bytes.size() - at)));
    while (auto packet = stream.next()) all.push_back(std::move(*packet));
  }
  while (stream.waiting()) {
    stream.give_up_waiting();
    while (auto packet = stream.next()) all.push_back(std::move(*packet));
  }
  return all;
}

std::vector<arbotix::HeadCommand> commands(ByteView bytes, std::size_t chunk) {
  arbotix::CommandStream stream;
  std::vector<arbotix::HeadCommand> all;
  for (std::size_t at = 0; at < bytes.size(); at += chunk) {
    stream.push(bytes.subspan(at, std::min(chunk, bytes.size() - at)));
    while (const auto command = stream.next()) all.push_back(*command);
  }
  return all;
}

std::string text_of(const Bytes& bytes) {
  return {bytes.begin(), bytes.end()};
}

void ask_servos(ByteView bytes) {
  ServoBus bus{{ServoModel(1, 0.0), ServoModel(2, 0.0)}};
  bus.receive(bytes);
  bus.step(std::chrono::milliseconds(500));
  dynamixel::PacketStream stream;
  stream.push(bus.take_output());
  while (stream.next()) {
  }
  if (stream.counters().bad_sum != 0) __builtin_trap();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (packets({data, size}, 1) != packets({data, size}, size + 1)) __builtin_trap();
  if (commands({data, size}, 1) != commands({data, size}, size + 1)) __builtin_trap();
  ask_servos({data, size});
  return 0;
}

std::vector<std::string> striate::fuzz::seeds() {
  return {text_of(dynamixel::move({{1, 0.2, 0.5}, {2, -0.3, 0.5}})) + text_of(dynamixel::ping(1)),
          text_of(arbotix::encode({700, 400, 0, 0})) + text_of(arbotix::encode({1, 2, 0, 0})),
          text_of(dynamixel::write_word(1, 6, 300)) + text_of(dynamixel::read(1, 0, 50)) +
              text_of(dynamixel::encode({2, 4, {30, 0, 2}})) +
              text_of(dynamixel::encode({2, 5, {}})) + text_of(dynamixel::encode({1, 6, {}}))};
}
