#include "striate/platform/pioneer/arcos/command.hpp"
#include "striate/platform/pioneer/arcos/config_pac.hpp"
#include "striate/platform/pioneer/arcos/other_packets.hpp"
#include "striate/platform/pioneer/arcos/packet_stream.hpp"
#include "striate/platform/pioneer/arcos/sip.hpp"
#include "tests/fuzz/fuzz_target.hpp"

using namespace striate;
using namespace striate::pioneer;

namespace {

std::vector<arcos::Packet> packets_of(ByteView bytes, std::size_t chunk) {
  arcos::PacketStream stream;
  std::vector<arcos::Packet> packets;
  const auto drain = [&] {
    while (auto packet = stream.next()) packets.push_back(std::move(*packet));
  };
  for (std::size_t at = 0; at < bytes.size(); at += chunk) {
    stream.push(bytes.subspan(at, std::min(chunk, bytes.size() - at)));
    drain();
  }
  while (stream.waiting()) {
    stream.give_up_waiting();
    drain();
  }
  return packets;
}

std::string text_of(const Bytes& bytes) {
  return {bytes.begin(), bytes.end()};
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::vector<arcos::Packet> packets = packets_of({data, size}, 1);
  if (packets != packets_of({data, size}, size + 1)) __builtin_trap();  // splits must not matter
  for (const arcos::Packet& packet : packets) {
    (void)arcos::read_argument(packet);
    (void)arcos::read_names(packet);
    (void)arcos::read_joystick(packet);
    (void)arcos::read_sim_stat(packet);
    (void)arcos::read_sim_laser(packet);
    (void)arcos::read_config_pac(packet);
    (void)arcos::read_sip(packet);
  }
  // Checksums hide the readers from mutations: hand them the raw bytes, too.
  for (const std::uint8_t id : {0x32, 0x20, 0x02, 0x61, 0x62, 0xf8}) {
    const arcos::Packet packet{id, Bytes(data, data + size)};
    (void)arcos::read_sip(packet);
    (void)arcos::read_config_pac(packet);
    (void)arcos::read_names(packet);
    (void)arcos::read_sim_laser(packet);
    (void)arcos::read_sim_stat(packet);
    (void)arcos::read_joystick(packet);
    (void)arcos::read_argument(packet);
  }
  return 0;
}

std::vector<std::string> striate::fuzz::seeds() {
  arcos::Sip sip;
  sip.sonar.assign(16, {3, 1000});
  arcos::ConfigPac config;
  config.type = "Pioneer";
  config.firmware = "3.0";
  std::string all = text_of(arcos::command(arcos::Command::velocity, -300));
  all += text_of(arcos::encode(arcos::write_sip(sip)));
  all += text_of(arcos::encode(arcos::write_config_pac(config)));
  all += text_of(arcos::encode(arcos::write_sim_laser(std::vector<std::uint16_t>(20, 500))[0]));
  const Bytes payload = arcos::write_sip(sip).payload;
  return {all, text_of(payload), text_of(arcos::write_config_pac(config).payload)};
}
