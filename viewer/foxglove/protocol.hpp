#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "striate/base/bytes.hpp"

/// What is said between Foxglove, Lichtblick and us: the Foxglove WebSocket protocol, version 1.
/// Its specification is docs/spec.md of the repository foxglove/ws-protocol.
namespace striate::viewer::foxglove {

/// The names under which a client asks for the protocol; what is said is the same.
inline constexpr std::array<std::string_view, 2> kSubprotocols{"foxglove.sdk.v1",
                                                               "foxglove.websocket.v1"};

/// The first that the client offers of ours. @param offered Sec-WebSocket-Protocol, commas between
[[nodiscard]] std::optional<std::string_view> choose_subprotocol(std::string_view offered);

/// What a client may ask of the robot beside looking.
enum class Service : std::uint8_t { pause = 1, resume, stop };

/// What is shown beside the channels.
struct ServerFacts {
  std::string name;     ///< "striate 0.1.0: task corridor"
  std::string session;  ///< differs from server to server: clients forget what they knew
  bool drives = false;  ///< clients may publish on /cmd_vel
  std::vector<std::pair<std::string, std::string>> parameters;  ///< settings in force, as printed
};

// What the server says; texts are JSON.
[[nodiscard]] std::string server_info(const ServerFacts& facts);
/// All of channel_list(); the id of a channel is its Topic.
[[nodiscard]] std::string advertise_channels();
[[nodiscard]] std::string advertise_services();
enum class StatusLevel : std::uint8_t { info, warning, error };
[[nodiscard]] std::string status(StatusLevel level, const std::string& message);
/// @param names those that are asked for; none: all
[[nodiscard]] std::string parameter_values(const ServerFacts& facts,
                                           const std::vector<std::string>& names,
                                           const std::optional<std::string>& request);
[[nodiscard]] std::string service_failure(std::uint32_t service, std::uint32_t call,
                                          const std::string& why);
/// The bytes before the payload of a message.
using MessageHead = std::array<std::uint8_t, 13>;
[[nodiscard]] MessageHead message_head(std::uint32_t subscription, std::uint64_t time_ns);
[[nodiscard]] Bytes time_message(std::uint64_t time_ns);

// What a client says.
struct Subscribe {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> subscriptions;  ///< id, channel
};
struct Unsubscribe {
  std::vector<std::uint32_t> subscriptions;
};
struct ClientChannel {
  std::uint32_t id = 0;
  std::string topic;
  std::string encoding;
  std::string schema_name;
};
struct ClientAdvertise {
  std::vector<ClientChannel> channels;
};
struct ClientUnadvertise {
  std::vector<std::uint32_t> channels;
};
struct ClientMessage {
  std::uint32_t channel = 0;
  ByteView payload;  ///< of the bytes that were read
};
struct ServiceCall {
  std::uint32_t service = 0;
  std::uint32_t call = 0;
  std::string encoding;
};
struct GetParameters {
  std::vector<std::string> names;
  std::optional<std::string> request;
};
struct SetParameters {
  std::optional<std::string> request;
};
/// Something that the specification knows and this server has no use for.
struct NotOffered {
  std::string what;
};
using Request = std::variant<Subscribe, Unsubscribe, ClientAdvertise, ClientUnadvertise,
                             ClientMessage, ServiceCall, GetParameters, SetParameters, NotOffered>;

/// @throws BadBytes with what is wrong, for the client to read
[[nodiscard]] Request read_text_request(std::string_view text);
/// @param bytes must live as long as what is read. @throws BadBytes
[[nodiscard]] Request read_binary_request(ByteView bytes);

/// The answer to a call of std_srvs/srv/Trigger, in the encoding of the call ("cdr" or "json").
[[nodiscard]] Bytes service_response(const ServiceCall& call, bool success,
                                     const std::string& message);

}  // namespace striate::viewer::foxglove
