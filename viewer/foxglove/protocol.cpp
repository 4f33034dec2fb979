#include "striate/viewer/foxglove/protocol.hpp"

#include <fmt/format.h>

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
constexpr std::uint8_t kClientMessageData = 1;
constexpr std::uint8_t kServiceRequest = 2;

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

// Reading. An error message names the field that is wrong.

const ProtocolJson& field_of(const ProtocolJson& json, const char* name) {
  const auto found = json.find(name);
  if (found == json.end()) throw BadBytes(fmt::format("'{}' is missing", name));
  return *found;
}

std::uint32_t id_of(const ProtocolJson& json, const char* name) {
  const bool good = json.is_number_integer() && json >= 0 && json <= 0xFFFFFFFFU;
  if (!good) throw BadBytes(fmt::format("'{}' is no whole number of 32 bits", name));
  return json.get<std::uint32_t>();
}

std::string text_of(const ProtocolJson& json, const char* name) {
  if (!json.is_string()) throw BadBytes(fmt::format("'{}' is no text", name));
  return json.get<std::string>();
}

const ProtocolJson& list_in(const ProtocolJson& json, const char* name) {
  const ProtocolJson& list = field_of(json, name);
  if (!list.is_array()) throw BadBytes(fmt::format("'{}' is no list", name));
  return list;
}

std::vector<std::uint32_t> ids_in(const ProtocolJson& json, const char* name) {
  std::vector<std::uint32_t> ids;
  for (const ProtocolJson& one : list_in(json, name)) ids.push_back(id_of(one, name));
  return ids;
}

std::optional<std::string> request_id_in(const ProtocolJson& json) {
  const auto found = json.find("id");
  if (found == json.end() || found->is_null()) return std::nullopt;
  return text_of(*found, "id");
}

Subscribe read_subscribe(const ProtocolJson& json) {
  Subscribe request;
  for (const ProtocolJson& one : list_in(json, "subscriptions")) {
    if (!one.is_object()) throw BadBytes("a subscription is no object");
    request.subscriptions.emplace_back(id_of(field_of(one, "id"), "id"),
                                       id_of(field_of(one, "channelId"), "channelId"));
  }
  return request;
}

ClientAdvertise read_client_advertise(const ProtocolJson& json) {
  ClientAdvertise request;
  for (const ProtocolJson& one : list_in(json, "channels")) {
    if (!one.is_object()) throw BadBytes("a channel is no object");
    request.channels.push_back({id_of(field_of(one, "id"), "id"),
                                text_of(field_of(one, "topic"), "topic"),
                                text_of(field_of(one, "encoding"), "encoding"),
                                text_of(field_of(one, "schemaName"), "schemaName")});
  }
  return request;
}

GetParameters read_get_parameters(const ProtocolJson& json) {
  GetParameters request;
  for (const ProtocolJson& one : list_in(json, "parameterNames")) {
    request.names.push_back(text_of(one, "parameterNames"));
  }
  request.request = request_id_in(json);
  return request;
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

Request read_text_request(std::string_view text) {
  const ProtocolJson json = ProtocolJson::parse(text, nullptr, false);
  if (!json.is_object()) throw BadBytes("a text message is no JSON object");
  const std::string op = text_of(field_of(json, "op"), "op");
  if (op == "subscribe") return read_subscribe(json);
  if (op == "unsubscribe") return Unsubscribe{ids_in(json, "subscriptionIds")};
  if (op == "advertise") return read_client_advertise(json);
  if (op == "unadvertise") return ClientUnadvertise{ids_in(json, "channelIds")};
  if (op == "getParameters") return read_get_parameters(json);
  if (op == "setParameters") return SetParameters{request_id_in(json)};
  return NotOffered{op.substr(0, 40)};  // by hand: longer than any name of the specification
}

Request read_binary_request(ByteView bytes) {
  ByteReader reader(bytes);
  const std::uint8_t op = reader.u8();
  if (op == kClientMessageData) {
    const std::uint32_t channel = reader.u32();
    return ClientMessage{channel, bytes.last(reader.left())};
  }
  if (op != kServiceRequest) return NotOffered{fmt::format("binary opcode {}", op)};
  ServiceCall call;
  call.service = reader.u32();
  call.call = reader.u32();
  call.encoding = reader.take_text();
  return call;
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
