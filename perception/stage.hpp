#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "striate/base/named_table.hpp"
#include "striate/perception/percept.hpp"
#include "striate/platform/interface/robot.hpp"

namespace striate::perception {

/// A stage of perception that is not ours. It sees each image pair once, after our own stages, and
/// says what it found in figures, which short-term memory keeps for conditions and behaviours.
class Stage {
 public:
  Stage() = default;
  virtual ~Stage() = default;
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;

  /// @param frame the images; `right` may be empty
  /// @param percept what our stages found in them
  /// @param figures one value for each name in StageEntry::figures, in that order; NaN, as they
  /// come in, says that nothing is known
  virtual void see(const StereoFrame& frame, const Percept& percept, std::span<double> figures) = 0;
};

/// One stage that perception runs.
struct StageEntry {
  std::string name;
  std::string help;                  ///< one line
  std::vector<std::string> figures;  ///< memory knows them as "NAME.FIGURE", cut at 63 bytes
  /// May throw UserError. The description is that of the body that is driven.
  std::function<std::unique_ptr<Stage>(const RobotDescription& robot)> make;
};

using StageRegistry = NamedTable<StageEntry>;

/// The stages of plugins, in the order in which they run. One table of the whole process.
[[nodiscard]] const StageRegistry& stage_registry();

/// Takes in one more, before the first perception is made; for plugins alone
/// (agent/plugins/load_plugin.hpp). @return false where the name is taken
bool enroll(StageEntry entry);

}  // namespace striate::perception
