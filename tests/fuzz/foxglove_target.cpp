#include <memory>
#include <nlohmann/json.hpp>

#include "striate/base/steady_clock.hpp"
#include "striate/viewer/foxglove/access.hpp"
#include "striate/viewer/foxglove/conversation.hpp"
#include "tests/fuzz/fuzz_target.hpp"

using namespace striate;
using namespace striate::viewer;
using namespace striate::viewer::foxglove;

/// All that a client may send, behind the frames of its socket: one message a line, whose first
/// letter says whether it is text or binary. And the head of a handshake.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const SteadyClock clock;
  RemotePilot pilot(clock, 0.0);
  Host host;
  host.facts.drives = true;
  host.facts.parameters = {{"a.b", "3"}, {"a.c", "0.5 m"}};
  host.newest.fill({7, std::make_shared<const Bytes>(20, 1)});
  host.pilot = &pilot;
  host.stop = [] {};
  Conversation talk(host, 1);
  talk.greet();
  std::string_view rest(reinterpret_cast<const char*>(data), size);
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    const std::string_view line = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    AccessRules rules;
    rules.token = "a token";
    (void)why_refused(rules, {line, line, line, line, line});
    (void)why_page_refused(rules, {line, line, line, line, line});
    (void)cookie_for(rules, {line, line, line, line, line});
    (void)choose_subprotocol(line);
    if (line.empty()) continue;
    const std::string_view message = line.substr(1);
    if (line.front() == 't') {
      talk.hear_text(message);
    } else {
      talk.hear_binary({reinterpret_cast<const std::uint8_t*>(message.data()), message.size()},
                       clock.now());
    }
    (void)pilot.wish(TimePoint());
    while (!talk.queue().empty()) {
      const Frame frame = talk.queue().pop();
      // What is answered in text is JSON, whatever was asked.
      if (frame.text && !nlohmann::json::accept(frame.body->begin(), frame.body->end())) {
        std::abort();
      }
    }
  }
  return 0;
}

std::vector<std::string> striate::fuzz::seeds() {
  const std::string subscribe =
      R"(t{"op":"subscribe","subscriptions":[{"id":0,"channelId":3},{"id":1,"channelId":21}]})"
      "\n";
  const std::string announce =
      R"(t{"op":"advertise","channels":[{"id":1,"topic":"/cmd_vel","encoding":"json",)"
      R"("schemaName":"geometry_msgs/msg/Twist"},{"id":2,"topic":"/cmd_vel","encoding":"cdr",)"
      R"("schemaName":"geometry_msgs/msg/TwistStamped"}]})"
      "\n";
  const std::string json_twist =
      std::string("b\x01\x01\0\0\0", 6) + R"({"linear":{"x":0.3},"angular":{"z":0.1}})" + "\n";
  std::string cdr_twist("b\x01\x02\0\0\0\0\x01\0\0", 10);
  cdr_twist +=
      std::string(8, 5) + std::string("\x02\0\0\0a\0\0\0\0\0\0\0", 12) + std::string(48, 1) + "\n";
  const std::string call("b\x02\x01\0\0\0\x05\0\0\0\x03\0\0\0cdr\0\x01\0\0\0\n", 23);
  return {subscribe + R"(t{"op":"unsubscribe","subscriptionIds":[0]})" + "\n" + call,
          announce + json_twist + cdr_twist + R"(t{"op":"unadvertise","channelIds":[1,2]})",
          R"(t{"op":"getParameters","parameterNames":["a.b"],"id":"x"})"
          "\n"
          R"(t{"op":"setParameters","parameters":[{"name":"a.b","value":4}],"id":"y"})",
          "http://localhost:8765\n[::1]:1\n/?a=b&token=0123\nfoxglove.sdk.v1, "
          "foxglove.websocket.v1\n"};
}
