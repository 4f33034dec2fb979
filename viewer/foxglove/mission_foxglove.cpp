#include "striate/viewer/foxglove/mission_foxglove.hpp"

#include <fmt/format.h>

#include "striate/agent/recording/setup.hpp"
#include "striate/base/version.hpp"
#include "striate/viewer/dashboard/what.hpp"

namespace striate::viewer {
namespace {

foxglove::ServerFacts server_facts(const char* what, const tasks::Task& task,
                                   const agent::RobotSettings& settings) {
  foxglove::ServerFacts facts;
  facts.name = fmt::format("striate {}, {} {}", kVersion, what, task.mission);
  for (const auto& [key, value] : agent::printed_settings(settings)) {
    facts.parameters.emplace_back(key, value);
  }
  return facts;
}

/// The page of a robot, beside what was added to its site before.
void show_live(const foxglove::ServerOptions& options, const char* kind, const tasks::Task& task) {
  if (!options.site) return;
  dashboard::What what;
  what.kind = kind;
  what.title = task.mission.empty() ? task.file : task.mission;
  what.pages = options.pages;
  what.drives = options.drives;
  what.changes = options.changes;
  what.pages.insert(what.pages.begin(), "live");
  dashboard::add_what(*options.site, what);
}

}  // namespace

void MissionFoxglove::begin(const foxglove::ServerOptions& options, agent::Mission& mission) {
  const tasks::Task& task = mission.executive().task();
  show_live(options, "run", task);
  server_ = std::make_unique<foxglove::FoxgloveServer>(
      options, server_facts("runs", task, mission.settings()),
      Channels(mission.body().description(), task));
  mission.set_pilot([server = server_.get()](TimePoint now) { return server->pilot().wish(now); });
}

void MissionFoxglove::begin(const foxglove::ServerOptions& options,
                            const agent::ReplayMission& mission) {
  const tasks::Task& task = mission.executive().task();
  foxglove::ServerOptions looked_at = options;
  looked_at.drives = false;
  show_live(looked_at, "replay", task);
  server_ = std::make_unique<foxglove::FoxgloveServer>(
      looked_at, server_facts("replays", task, mission.settings()),
      Channels(mission.robot(), task));
}

void MissionFoxglove::take(const agent::CognitiveCycle& cycle, const tasks::Executive& executive,
                           std::uint64_t number) {
  if (!server_) return;
  const bool taken =
      server_->put([&](CycleFacts& facts) { taker_.take(cycle, executive, number, facts); });
  if (!taken) taker_.lost();
}

void MissionFoxglove::take(const agent::Mission& mission) {
  take(mission.cycle(), mission.executive(), mission.cycles());
}

void MissionFoxglove::take(const agent::ReplayMission& mission) {
  take(mission.cycle(), mission.executive(), mission.recorded().number);
}

void MissionFoxglove::finish() {
  if (server_) server_->finish();
}

}  // namespace striate::viewer
