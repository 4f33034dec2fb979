#include <opencv2/core/mat.hpp>
#include <string_view>

#include "striate/base/base64.hpp"
#include "striate/base/user_error.hpp"
#include "striate/platform/interface/plausible.hpp"
#include "striate/platform/rosbridge/bridge_address.hpp"
#include "striate/platform/rosbridge/message_reader.hpp"
#include "tests/fuzz/fuzz_target.hpp"

using namespace striate;
using namespace striate::rosbridge;

namespace {

BridgeSettings fuzzed_settings() {
  BridgeSettings settings;
  settings.topics.left_image = "/l";
  settings.topics.right_image = "/r/compressed";
  settings.topics.left_info = "/li";
  settings.topics.right_info = "/ri";
  settings.topics.scan = "/s";
  settings.most_message_mb = 1;
  return settings;
}

}  // namespace

/// All that a rosbridge server may send, one message a line; and each line as an address. Whatever
/// it is, what is felt afterwards can be.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const BridgeSettings settings = fuzzed_settings();
  MessageReader reader(settings);
  remote::Inbox inbox(settings);
  std::string_view rest(reinterpret_cast<const char*>(data), size);
  TimePoint now;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    const std::string_view line = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    now += std::chrono::milliseconds(100);
    take(reader.read(line), now, inbox);
    try {
      (void)read_bridge_address(std::string(line));
    } catch (const UserError&) {
    }
  }
  if (!why_implausible(inbox.senses()).empty()) std::abort();
  if (!why_implausible(inbox.senses().stereo).empty()) std::abort();
  return 0;
}

std::vector<std::string> striate::fuzz::seeds() {
  const std::string info = R"("width":24,"height":18,"P":[20,0,11.5,0,0,20,8.5,0,0,0,1,0]}})"
                           "\n";
  const std::string right_info = R"("width":24,"height":18,"p":[20,0,11.5,-2,0,20,8.5,0,0,0,1,0]}})"
                                 "\n";
  const std::string pixels = to_base64(std::vector<std::uint8_t>(std::size_t{24} * 18, 90));
  return {
      R"({"op":"publish","topic":"/odom","msg":{"header":{"stamp":{"sec":5,"nanosec":7}},)"
      R"("pose":{"pose":{"position":{"x":1,"y":2,"z":0},"orientation":{"x":0,"y":0,"z":0,"w":1}}},)"
      R"("twist":{"twist":{"linear":{"x":0.1},"angular":{"z":0.1}}}}})"
      "\n"
      R"({"op":"status","level":"error","msg":"no"})"
      "\nws://[::1]:9090/a?b=c\nws://robot:9090\n",
      R"({"op":"publish","topic":"/s","msg":{"header":{"stamp":{"secs":5,"nsecs":7}},)"
      R"("angle_min":-1,"angle_increment":0.5,"range_min":0.1,"range_max":9,)"
      R"("ranges":[null,1,2.5,99]}})",
      R"({"op":"publish","topic":"/li","msg":{)" + info +
          R"({"op":"publish","topic":"/ri","msg":{)" + right_info +
          R"({"op":"publish","topic":"/l","msg":{"width":24,"height":18,"step":24,)"
          R"("encoding":"mono8","is_bigendian":0,"data":")" +
          pixels +
          R"("}})"
          "\n"
          R"({"op":"publish","topic":"/r/compressed","msg":{"data":[137,80,78,71]}})"
          "\n"};
}
