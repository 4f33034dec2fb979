#pragma once

#include <memory>
#include <string>

#include "striate/agent/mission.hpp"
#include "striate/agent/replay/replay_mission.hpp"
#include "striate/viewer/foxglove/foxglove_server.hpp"

namespace striate::viewer {

/// A mission, or a recorded one, shown to Foxglove and Lichtblick while it runs. Only looking
/// changes nothing of it.
class MissionFoxglove {
 public:
  /// Listens, and lets viewers pause the mission and drive where they may.
  /// @throws UserError where nothing can be listened on; nothing has moved yet
  void begin(const foxglove::ServerOptions& options, agent::Mission& mission);
  /// Nobody drives a recording.
  void begin(const foxglove::ServerOptions& options, const agent::ReplayMission& mission);

  /// After each cycle.
  void take(const agent::Mission& mission);
  void take(const agent::ReplayMission& mission);
  /// Says the last things and ends.
  void finish();

  [[nodiscard]] std::string url() const { return server_ ? server_->url() : std::string(); }
  [[nodiscard]] std::string page_url() const {
    return server_ ? server_->page_url() : std::string();
  }
  /// A viewer has asked for a safe end.
  [[nodiscard]] bool stop_asked() const { return server_ && server_->stop_asked(); }
  /// A viewer has paused it: the robot stands; a recording is to wait.
  [[nodiscard]] bool paused() const { return server_ && server_->pilot().paused(); }

 private:
  void take(const agent::CognitiveCycle& cycle, const tasks::Executive& executive,
            std::uint64_t number);

  std::unique_ptr<foxglove::FoxgloveServer> server_;
  FactsTaker taker_;
};

}  // namespace striate::viewer
