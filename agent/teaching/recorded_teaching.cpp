#include "striate/agent/teaching/recorded_teaching.hpp"

#include <fmt/format.h>

#include "striate/agent/replay/replay_mission.hpp"
#include "striate/agent/robot_settings.hpp"
#include "striate/agent/teaching/live_teacher.hpp"
#include "striate/base/user_error.hpp"

namespace striate::agent {

LiveViews take_views(const RecordedTeaching& recorded) {
  ReplayMission mission({recorded.recording, recorded.robot, {}});
  LiveTeacher teacher(mission.settings().long_term_memory, mission.robot());
  std::size_t looks = 0;
  double last_s = 0.0;
  while (mission.step()) {
    const CycleTrace& trace = mission.cycle().trace();
    last_s = to_seconds(trace.senses.now);
    if (recorded.times_s.empty()) {
      teacher.take(trace);
    } else if (looks < recorded.times_s.size() && last_s >= recorded.times_s[looks]) {
      teacher.look(trace);
      ++looks;
    }
    if (!recorded.times_s.empty() && looks == recorded.times_s.size()) break;
  }
  if (looks < recorded.times_s.size()) {
    throw UserError(fmt::format("{}: ends at {:.1f} s, before --when {:.1f} s", recorded.recording,
                                last_s, recorded.times_s[looks]));
  }
  LiveViews seen;
  seen.views = teacher.views();
  seen.looked_in_vain = teacher.looked_in_vain();
  seen.result.outcome = RunOutcome::success;
  return seen;
}

}  // namespace striate::agent
