#include "striate/behaviours/go_to.hpp"

#include "striate/behaviours/control/short_format.hpp"

namespace striate::behaviours {

Wish GoTo::tick(const memory::ShortTermMemory& memory) {
  const memory::LandmarkInMind* landmark = memory.landmarks().find(settings_.landmark);
  if (landmark == nullptr || !landmark->place_known) {
    return failed_wish(memory, Failure::not_known,
                       short_format("does not know where '{}' is", settings_.landmark));
  }
  const double left_m = distance_to_m(memory, landmark->place);
  if (left_m <= settings_.stop_at_m) {
    return final_wish(memory, Progress::succeeded, short_format("at '{}'", settings_.landmark));
  }
  Wish wish = journey_.tick(memory, landmark->place, settings_.speed_m_s);
  if (wish.progress == Progress::running && wish.why.view() == "drives on") {
    wish.why = short_format("drives to '{}', {:.1f} m", settings_.landmark, left_m);
  }
  return wish;
}

}  // namespace striate::behaviours
