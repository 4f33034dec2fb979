#include "striate/agent/plugins/plugin.hpp"

#include <cmath>
#include <opencv2/imgproc.hpp>

using namespace striate;

/// How much the view changes from image to image: its mean difference, of full scale.
class Change final : public perception::Stage {
 public:
  /// The figures are those that the entry below names, in that order; what is left alone stays NaN,
  /// which says that nothing is known.
  void see(const StereoFrame& frame, const perception::Percept& /*percept*/,
           std::span<double> figures) override {
    cv::Mat3b small;  // means of many pixels, so that the camera's noise does not count as change
    cv::resize(frame.left, small, {16, 12}, 0.0, 0.0, cv::INTER_AREA);
    if (!before_.empty()) {
      figures[0] = cv::norm(small, before_, cv::NORM_L1) / (255.0 * 3.0 * small.total());
    }
    before_ = small;
  }

 private:
  cv::Mat3b before_;
};

/// The figure is read from memory, as a behaviour of the plugin would do it.
class ViewChanges final : public tasks::Condition {
 public:
  explicit ViewChanges(double limit) : limit_(limit) {}
  [[nodiscard]] bool holds(const memory::ShortTermMemory& memory) const override {
    return memory.figure("change.mean") >= limit_;  // false while it is NaN
  }

 private:
  double limit_;
};

void enroll(agent::PluginRegistrar& plugin) {
  plugin.add(perception::StageEntry{
      .name = "change",
      .help = "how much the view changes",
      .figures = {"mean"},
      .make = [](const RobotDescription&) { return std::make_unique<Change>(); }});
  plugin.add(tasks::ConditionEntry{.name = "view_changes",
                                   .help = "the view changes at least so much from image to image",
                                   .unit = config::Unit::fraction,
                                   .range = {0.0, 1.0},
                                   .example = "2 %",
                                   .make = [](double limit) -> std::unique_ptr<tasks::Condition> {
                                     return std::make_unique<ViewChanges>(limit);
                                   }});
}

STRIATE_PLUGIN("change", enroll)
