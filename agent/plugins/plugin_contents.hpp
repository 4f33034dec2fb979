#pragma once

#include <string>
#include <vector>

#include "striate/agent/plugins/plugin.hpp"

namespace striate::agent {

/// A plugin that was found good, with what it adds. Its code stays in the process for ever.
struct Plugin {
  std::string name;
  std::string file;  ///< absolute, without links
  std::vector<behaviours::BehaviourEntry> behaviours;
  std::vector<tasks::ConditionEntry> conditions;
  std::vector<perception::StageEntry> stages;
  std::vector<BodyEntry> bodies;
};

/// Notes what a plugin adds, and judges each name as it comes.
class PluginContents final : public PluginRegistrar {
 public:
  explicit PluginContents(Plugin& plugin) : plugin_(plugin) {}
  // Each throws UserError for an entry that is unsound or whose name is taken.
  void add(behaviours::BehaviourEntry entry) override;
  void add(tasks::ConditionEntry entry) override;
  void add(perception::StageEntry entry) override;
  void add(BodyEntry entry) override;

 private:
  [[noreturn]] void refuse(const std::string& what, const std::string& hint) const;
  void check_name(const std::string& kind, const std::string& name, bool taken) const;
  void check_whole(const std::string& kind, const std::string& name, bool whole) const;

  Plugin& plugin_;
};

}  // namespace striate::agent
