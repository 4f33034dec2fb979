#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "striate/viewer/foxglove/protocol.hpp"

namespace striate::viewer::foxglove {
namespace {

using ProtocolJson = nlohmann::ordered_json;

// Opcodes of the specification. An error message names the field that is wrong.
constexpr std::uint8_t kClientMessageData = 1;
constexpr std::uint8_t kServiceRequest = 2;

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

}  // namespace striate::viewer::foxglove
