#include "striate/platform/rosbridge/twist_keeper.hpp"

#include "striate/platform/rosbridge/bridge_client.hpp"
#include "striate/platform/rosbridge/operations.hpp"

namespace striate::rosbridge {
namespace {

/// The good-bye of its line, by hand; the mind does not wait any longer
constexpr auto kKeeperEnds = std::chrono::milliseconds(700);
/// Of messages, which the keeper asks for none of: those of the status
constexpr std::size_t kMostBytes = std::size_t{1} << 20U;

BridgeClient::Hears advertises_only(const BridgeSettings& settings) {
  return {.greetings = [settings] { return std::vector{greetings(settings, false).front()}; },
          .message = [](std::string_view) {},
          .broke = [] {},
          .tick = [] {}};
}

remote::KeeperVoice client_of_zeros(const BridgeSettings& settings) {
  auto client = std::make_shared<BridgeClient>(read_bridge_address(settings.url), kMostBytes,
                                               advertises_only(settings));
  const std::string zero = publish_twist(settings, {}, std::nullopt);
  return {[client, zero] { client->say_newest(zero); },
          [client, zero](bool died) {
            client->end(died ? std::vector{zero} : std::vector<std::string>{});
          }};
}

}  // namespace

std::unique_ptr<remote::ZeroKeeper> make_twist_keeper(const BridgeSettings& settings) {
  return std::make_unique<remote::ZeroKeeper>(
      "twist-keeper", [&settings] { return client_of_zeros(settings); }, kKeeperEnds);
}

}  // namespace striate::rosbridge
