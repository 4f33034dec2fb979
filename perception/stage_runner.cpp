#include "striate/perception/stage_runner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <string_view>

namespace striate::perception {

StageRunner::StageRunner(const StageRegistry* stages, const RobotDescription& robot) {
  if (stages == nullptr) return;
  for (const StageEntry& entry : *stages) {
    stages_.push_back({entry.make(robot), entry.figures.size()});
    for (const std::string& figure : entry.figures) {
      unknown_.emplace_back().name = std::string_view(fmt::format("{}.{}", entry.name, figure));
    }
  }
  values_.resize(unknown_.size());
}

void StageRunner::see(const StereoFrame& frame, Percept& percept) {
  if (stages_.empty()) return;
  std::fill(values_.begin(), values_.end(), std::numeric_limits<double>::quiet_NaN());
  std::span<double> rest(values_);
  for (const Awake& awake : stages_) {
    awake.stage->see(frame, percept, rest.first(awake.figures));
    rest = rest.subspan(awake.figures);
  }
  percept.figures = unknown_;
  for (std::size_t i = 0; i < values_.size(); ++i) percept.figures[i].value = values_[i];
}

}  // namespace striate::perception
