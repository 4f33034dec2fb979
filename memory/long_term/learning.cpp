#include "striate/memory/long_term/learning.hpp"

#include <cmath>

#include "striate/memory/long_term/activation.hpp"

namespace striate::memory {

bool Learning::same_place(const Point2& a, const Point2& b) const {
  return std::hypot(a.x_m - b.x_m, a.y_m - b.y_m) < settings_.new_use_after_m;
}

bool Learning::seen(std::int64_t landmark, const Point2& from) {
  KnownViews& known = known_[landmark];
  known.missed_frames = 0;
  known.was_missed = false;
  if (known.used && same_place(from, known.used_from)) return false;
  known.used = true;
  known.used_from = from;
  return true;
}

bool Learning::missed(std::int64_t landmark, const Point2& from) {
  KnownViews& known = known_[landmark];
  if (++known.missed_frames < settings_.missed_frames) return false;
  known.missed_frames = 0;
  if (known.was_missed && same_place(from, known.missed_from)) return false;
  known.was_missed = true;
  known.missed_from = from;
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

}  // namespace striate::memory
