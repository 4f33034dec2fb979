#include "striate/platform/pioneer/firmware/urg_device.hpp"
#include "striate/platform/pioneer/laser/scip.hpp"
#include "tests/fuzz/fuzz_target.hpp"

using namespace striate;
using namespace striate::pioneer;

namespace {

std::vector<std::string> echoes(ByteView bytes, std::size_t chunk) {
  scip::ReplyStream stream;
  std::vector<std::string> all;
  for (std::size_t at = 0; at < bytes.size(); at += chunk) {
    stream.push(bytes.subspan(at, std::min(chunk, bytes.size() - at)));
    while (const auto reply = stream.next()) {
      all.push_back(reply->echo);
      (void)scip::read_info(*reply);
      (void)scip::read_scan(*reply, scip::read_parameters(*reply).value_or(scip::Parameters()));
    }
  }
  return all;
}

/// A device's replies to anything are whole ones.
void ask_a_device(ByteView bytes) {
  UrgDevice device;
  device.receive(bytes);
  const TimePoint now(std::chrono::seconds(1));
  if (device.measures(now)) device.step(now, std::vector<int>(device.rays(), 1234));
  scip::ReplyStream stream;
  stream.push(device.take_output());
  while (stream.next()) {
  }
  if (stream.counters().bad_sum != 0) __builtin_trap();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size > 4096) return 0;  // beyond a reply's longest size splits may matter
  if (echoes({data, size}, 1) != echoes({data, size}, size + 1)) __builtin_trap();
  (void)scip::read_request(std::string(data, data + size));
  ask_a_device({data, size});
  return 0;
}

std::vector<std::string> striate::fuzz::seeds() {
  const scip::ScanRequest request{.first_step = 100, .last_step = 180};
  return {
      scip::write_reply(scip::write_scan(request, 77, std::vector<int>(81, 1234))),
      "PP\n00P\nMODL:URG-04LX(Hokuyo);I\nDMIN:20;4\nDMAX:5600;_\nARES:1024;\\\nAMIN:44;7\n"
      "AMAX:725;o\nAFRT:384;6\nSCAN:600;e\n\n",
      "BM\r\n00P\r\n\r\nMD0044072503000",
      "BM\nGD0044072501;a\nMS0044072500102;b\nTM0\nTM1\nTM2\nII\nCR03\nSS115200\nHS1\nRB\nRB\n"};
}
