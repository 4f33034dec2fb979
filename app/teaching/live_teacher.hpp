#pragma once

#include <vector>

#include "app/cognitive_cycle.hpp"
#include "memory/long_term/long_term_settings.hpp"
#include "memory/long_term/records.hpp"
#include "perception/recognition/thing_region.hpp"

namespace striate {

/// A view that a robot took of a thing, cut out of a picture.
/// @param left the left picture; the view's own picture is cut from it
[[nodiscard]] StoredView stored_view(const cv::Mat3b& left, const ThingRegion& thing,
                                     const LongTermSettings& settings);

/// Watches a robot that runs the behaviour `teach` and keeps a view whenever it says so. Nothing
/// goes to the disk.
class LiveTeacher {
 public:
  LiveTeacher(const LongTermSettings& settings, const RobotDescription& robot)
      : settings_(settings), robot_(robot) {}

  /// After each cycle. @return whether a view came in.
  bool take(const CycleTrace& trace);
  [[nodiscard]] const std::vector<StoredView>& views() const { return views_; }
  /// Looks in which no thing could be told from its surroundings.
  [[nodiscard]] int looked_in_vain() const { return in_vain_; }

 private:
  LongTermSettings settings_;
  RobotDescription robot_;
  std::vector<StoredView> views_;
  int in_vain_ = 0;
};

}  // namespace striate
