#include "striate/agent/teaching/live_teaching.hpp"

#include <fmt/format.h>

#include "striate/agent/teaching/live_teacher.hpp"

namespace striate::agent {

LiveViews take_views(const MissionOptions& options, const BodySource& body,
                     const Mission::EachCycle& each_cycle) {
  Mission mission(options, body);
  LiveTeacher teacher(mission.settings().long_term_memory, mission.body().description());
  LiveViews seen;
  seen.result = mission.run([&](const Mission& running) {
    teacher.take(running.cycle().trace());
    return each_cycle(running);
  });
  seen.views = teacher.views();
  seen.looked_in_vain = teacher.looked_in_vain();
  return seen;
}

std::vector<memory::StoredView> with_structure(const std::vector<memory::StoredView>& views,
                                               const memory::LongTermSettings& settings,
                                               std::vector<std::string>& remarks) {
  std::vector<memory::StoredView> sound;
  for (std::size_t k = 0; k < views.size(); ++k) {
    const int count = static_cast<int>(views[k].keypoints.size());
    if (count >= settings.least_keypoints) {
      sound.push_back(views[k]);
      continue;
    }
    remarks.push_back(fmt::format("view {} is left out: {} keypoints, at least {} are needed",
                                  k + 1, count, settings.least_keypoints));
  }
  return sound;
}

}  // namespace striate::agent
