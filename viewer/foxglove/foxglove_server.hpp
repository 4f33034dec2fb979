#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "striate/viewer/channels/channels.hpp"
#include "striate/viewer/dashboard/site.hpp"
#include "striate/viewer/foxglove/protocol.hpp"
#include "striate/viewer/foxglove/remote_pilot.hpp"

namespace striate::viewer::foxglove {

/// Where Foxglove and Lichtblick are waited for, and what they may.
struct ServerOptions {
  std::string address = "127.0.0.1";      ///< beyond loopback a token is needed
  std::uint16_t port = 8765;              ///< 0: any; the viewers' own default
  std::vector<std::string> more_origins;  ///< of pages that may look: "https://app.foxglove.dev"
  bool needs_token = false;               ///< on loopback, too
  bool drives = false;                    ///< viewers may publish on /cmd_vel
  /// Foxglove and Lichtblick are welcome; else only pages of our own.
  bool others = true;
  std::shared_ptr<dashboard::Site> site;  ///< what browsers are shown; nullptr: nothing
  std::vector<std::string> pages;         ///< of the site, beside the live one
  bool changes = false;                   ///< pages may change the memory
};

/// Shows a robot to Foxglove and Lichtblick, by a thread of its own. Whoever leaves facts never
/// waits: what is too slow, here or there, is left out. No client can do more than end its own
/// connection.
class FoxgloveServer {
 public:
  /// Clients at once, by hand: a class in front of one robot; 128 MB wait for them at most
  static constexpr std::size_t kMostClients = 16;

  /// Listens from now on. @throws UserError for an address or port that cannot be had
  FoxgloveServer(const ServerOptions& options, ServerFacts facts, Channels channels);
  /// As finish().
  ~FoxgloveServer();
  FoxgloveServer(const FoxgloveServer&) = delete;
  FoxgloveServer& operator=(const FoxgloveServer&) = delete;

  /// For a viewer to open: "ws://127.0.0.1:8765", with the token where one is needed
  [[nodiscard]] const std::string& url() const;
  /// For a browser to open: "http://127.0.0.1:8780/", with the token where one is needed
  [[nodiscard]] const std::string& page_url() const;

  /// Facts of a cycle, from the mission's thread. @param fill gets those of a cycle before.
  /// @return false: there was no room, and they are left out
  bool put(const std::function<void(CycleFacts&)>& fill);
  [[nodiscard]] RemotePilot& pilot();
  /// A client has asked for a safe end.
  [[nodiscard]] bool stop_asked() const;
  [[nodiscard]] std::size_t clients() const;

  /// Says what waits to those who listen, for half a second at most, and ends.
  void finish();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace striate::viewer::foxglove
