#include "striate/viewer/foxglove/protocol.hpp"

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>

#include "striate/viewer/channels/channel_list.hpp"

namespace striate::viewer::foxglove {
namespace {

using ProtocolJson = nlohmann::ordered_json;

// Opcodes of the specification; each way has its own.
constexpr std::uint8_t kMessageData = 1;
constexpr std::uint8_t kTime = 2;
constexpr std::uint8_t kServiceResponse = 3;

constexpr const char* kTrigger = "std_srvs/srv/Trigger";
constexpr const char* kTriggerResponse = "bool success\nstring message\n";

std::string protocol_text(const ProtocolJson& json) {
  return json.dump(-1, ' ', false, ProtocolJson::error_handler_t::replace);
}

std::string_view trimmed_word(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t");
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t") - begin + 1);
}

/// A plain number stays one; "0.5 m" and "on" are texts.
ProtocolJson parameter_value(const std::string& text) {
  double number = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error == std::errc() && end == text.data() + text.size()) return number;
  return text;
}

ProtocolJson definition_of_service(const char* type, const char* schema) {
  return {
      {"encoding", "cdr"}, {"schemaName", type}, {"schemaEncoding", "ros2msg"}, {"schema", schema}};
}

}  // namespace

std::optional<std::string_view> choose_subprotocol(std::string_view offered) {
  while (!offered.empty()) {
    const std::size_t comma = offered.find(',');
    const std::string_view word = trimmed_word(offered.substr(0, comma));
    const auto* found = std::find(kSubprotocols.begin(), kSubprotocols.end(), word);
    if (found != kSubprotocols.end()) return *found;
    if (comma == std::string_view::npos) break;
    offered.remove_prefix(comma + 1);
  }
  return std::nullopt;
}

std::string server_info(const ServerFacts& facts) {
  ProtocolJson can = {"time", "parameters", "services"};
  if (facts.drives) can.push_back("clientPublish");
  return protocol_text({{"op", "serverInfo"},
                        {"name", facts.name},
                        {"capabilities", can},
                        {"supportedEncodings", {"cdr", "json"}},
                        // By it viewers choose the definitions of the messages that they publish.
                        {"metadata", {{"ROS_DISTRO", "humble"}}},
                        {"sessionId", facts.session}});
}

std::string advertise_channels() {
  ProtocolJson channels = ProtocolJson::array();
  for (const ChannelInfo& channel : channel_list()) {
    channels.push_back({{"id", static_cast<unsigned>(channel.topic)},
                        {"topic", channel.name},
                        {"encoding", channel.encoding},
                        {"schemaName", channel.schema_name},
                        {"schema", channel.schema},
                        {"schemaEncoding", channel.schema_encoding}});
  }
  return protocol_text({{"op", "advertise"}, {"channels", channels}});
}

std::string advertise_services() {
  ProtocolJson services = ProtocolJson::array();
  for (const auto& [service, name] :
       {std::pair(Service::pause, "/striate/pause"), std::pair(Service::resume, "/striate/resume"),
        std::pair(Service::stop, "/striate/stop")}) {
    services.push_back(
        {{"id", static_cast<unsigned>(service)},
         {"name", name},
         {"type", kTrigger},
         {"request", definition_of_service("std_srvs/srv/Trigger_Request", "")},
         {"response", definition_of_service("std_srvs/srv/Trigger_Response", kTriggerResponse)},
         // Clients of before 2024 read these two.
         {"requestSchema", ""},
         {"responseSchema", kTriggerResponse}});
  }
  return protocol_text({{"op", "advertiseServices"}, {"services", services}});
}

std::string status(StatusLevel level, const std::string& message) {
  return protocol_text(
      {{"op", "status"}, {"level", static_cast<unsigned>(level)}, {"message", message}});
}

std::string parameter_values(const ServerFacts& facts, const std::vector<std::string>& names,
                             const std::optional<std::string>& request) {
  ProtocolJson values = ProtocolJson::array();
  for (const auto& [name, value] : facts.parameters) {
    const bool asked = names.empty() || std::find(names.begin(), names.end(), name) != names.end();
    if (asked) values.push_back({{"name", name}, {"value", parameter_value(value)}});
  }
  ProtocolJson answer = {{"op", "parameterValues"}, {"parameters", values}};
  if (request) answer["id"] = *request;
  return protocol_text(answer);
}

std::string service_failure(std::uint32_t service, std::uint32_t call, const std::string& why) {
  return protocol_text(
      {{"op", "serviceCallFailure"}, {"serviceId", service}, {"callId", call}, {"message", why}});
}

MessageHead message_head(std::uint32_t subscription, std::uint64_t time_ns) {
  ByteWriter writer;
  writer.u8(kMessageData);
  writer.u32(subscription);
  writer.put(time_ns);
  MessageHead head{};
  std::copy(writer.bytes().begin(), writer.bytes().end(), head.begin());
  return head;
}

Bytes time_message(std::uint64_t time_ns) {
  ByteWriter writer;
  writer.u8(kTime);
  writer.put(time_ns);
  return writer.bytes();
}

Bytes service_response(const ServiceCall& call, bool success, const std::string& message) {
  ByteWriter writer;
  writer.u8(kServiceResponse);
  writer.u32(call.service);
  writer.u32(call.call);
  writer.put_text(call.encoding);
  Bytes bytes = writer.bytes();
  if (call.encoding == "json") {
    const std::string text = protocol_text({{"success", success}, {"message", message}});
    bytes.insert(bytes.end(), text.begin(), text.end());
    return bytes;
  }
  ByteWriter cdr;
  cdr.put(std::uint32_t{0x0100});                // CDR, little-endian: 00 01 00 00
  cdr.put(static_cast<std::uint32_t>(success));  // and three bytes up to the next number
  cdr.u32(static_cast<std::uint32_t>(message.size() + 1));
  append(bytes, cdr.bytes());
  ByteWriter(bytes).put_c_string(message);
  return bytes;
}

}  // namespace striate::viewer::foxglove
