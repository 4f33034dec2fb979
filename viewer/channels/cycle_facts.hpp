#pragma once

#include <cstdint>
#include <optional>

#include "striate/agent/cognitive_cycle.hpp"
#include "striate/viewer/channels/shown_facts.hpp"

namespace striate::viewer {

/// Takes the facts of one cycle after the other, into room that is used again. All that it decides
/// it decides by the mission's own clock: the same run gives the same facts.
class FactsTaker {
 public:
  /// After each cycle. @param number of the cycle, from 1
  void take(const agent::CognitiveCycle& cycle, const tasks::Executive& executive,
            std::uint64_t number, CycleFacts& facts);
  /// What was taken last got lost: images and the like are to be taken again.
  void lost() { *this = {}; }

 private:
  void take_vision(const agent::CycleTrace& trace, CycleFacts& facts);
  bool due(TimePoint now, std::optional<TimePoint>& last, Duration every);

  std::optional<TimePoint> image_;
  std::optional<TimePoint> percept_;
  std::optional<TimePoint> slow_;
  std::optional<TimePoint> global_;
};

}  // namespace striate::viewer
