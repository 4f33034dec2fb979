#pragma once

#include <vector>

#include "striate/agent/cognitive_cycle.hpp"
#include "striate/memory/long_term/long_term_settings.hpp"
#include "striate/memory/long_term/records.hpp"
#include "striate/perception/recognition/thing_region.hpp"

namespace striate::agent {

/// A view that a robot took of a thing, cut out of an image.
/// @param left the left image; the view's own image is cut from it
[[nodiscard]] memory::StoredView stored_view(const cv::Mat3b& left,
                                             const perception::ThingRegion& thing,
                                             const memory::LongTermSettings& settings);

/// Watches a robot that runs the behaviour `teach` and keeps a view whenever it says so. Nothing
/// goes to the disk.
class LiveTeacher {
 public:
  LiveTeacher(const memory::LongTermSettings& settings, const RobotDescription& robot)
      : settings_(settings), robot_(robot) {}

  /// After each cycle: looks where `teach` says so. @return whether a view came in.
  bool take(const CycleTrace& trace);
  /// Takes a view of what stands out ahead, whoever asks. @return whether there was something.
  bool look(const CycleTrace& trace);
  [[nodiscard]] const std::vector<memory::StoredView>& views() const { return views_; }
  /// Looks in which no thing could be told from its surroundings.
  [[nodiscard]] int looked_in_vain() const { return in_vain_; }

 private:
  memory::LongTermSettings settings_;
  RobotDescription robot_;
  std::vector<memory::StoredView> views_;
  int in_vain_ = 0;
};

}  // namespace striate::agent
