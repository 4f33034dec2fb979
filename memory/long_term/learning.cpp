#include "memory/long_term/learning.hpp"

#include <cmath>

#include "memory/long_term/activation.hpp"

namespace striate {

bool Learning::seen(std::int64_t landmark, const Point2& from) {
  Known& known = known_[landmark];
  known.missed_frames = 0;
  const double moved_m = std::hypot(from.x_m - known.used_from.x_m, from.y_m - known.used_from.y_m);
  if (known.used && moved_m < settings_.new_use_after_m) return false;
  known.used = true;
  known.used_from = from;
  return true;
}

bool Learning::missed(std::int64_t landmark) {
  Known& known = known_[landmark];
  if (++known.missed_frames < settings_.missed_frames) return false;
  known.missed_frames = 0;
  return true;
}

void keep_sighting(MemoryTables& tables, const std::string& name, double now_s,
                   const LongTermSettings& settings) {
  std::optional<Landmark> landmark = tables.landmarks.find(name);
  if (!landmark) return;
  note_use(landmark->history, now_s);
  landmark->strength = consolidated(landmark->strength, settings);
  tables.landmarks.update(*landmark);
}

void keep_miss(MemoryTables& tables, const std::string& name, const LongTermSettings& settings) {
  std::optional<Landmark> landmark = tables.landmarks.find(name);
  if (!landmark) return;
  landmark->strength = enfeebled(landmark->strength, settings);
  tables.landmarks.update(*landmark);
}

}  // namespace striate
