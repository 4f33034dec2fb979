#include "striate/memory/long_term/forgetting.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "striate/base/shell_text.hpp"
#include "striate/base/user_error.hpp"
#include "striate/config/quantity.hpp"
#include "striate/memory/long_term/activation.hpp"
#include "striate/memory/long_term/teaching.hpp"

namespace striate::memory {
namespace {

void note(MemoryTables& tables, const std::string& kind, const std::string& name,
          const std::string& text) {
  Episode episode;
  episode.time_s = tables.sessions.operating_now_s();
  episode.kind = kind;
  episode.landmark = name;
  episode.text = text;
  tables.sessions.add(episode);
}

}  // namespace

std::string why_forgettable(const Landmark& landmark, double now_s,
                            const LongTermSettings& settings) {
  if (landmark.pinned || landmark.retired_s || landmark.kind == LandmarkKind::taught) return "";
  const double base = base_level(landmark.history, now_s, settings.decay);
  if (landmark.strength >= settings.weak_below || base >= settings.inactive_below) return "";
  return fmt::format("weak (strength {:.2f}) and inactive (activation {:.1f})", landmark.strength,
                     base);
}

Landmark find_landmark(MemoryTables& tables, const std::string& name) {
  if (std::optional<Landmark> found = tables.landmarks.find(name)) return *found;
  std::vector<std::string> names;
  for (Landmark& landmark : tables.landmarks.all(true)) {
    // A file from elsewhere may hold a name that is no plain text: it answers to what is shown of
    // it.
    if (landmark.name == name) return landmark;
    names.push_back(landmark.name);
  }
  const std::string like = config::suggest(name, names);
  throw UserError(
      fmt::format("there is no landmark '{}'{}\n    'striate memory FILE list --all' lists all",
                  name, like.empty() ? "" : "; " + like));
}

void forget(MemoryTables& tables, const std::string& name, const std::string& why) {
  Landmark landmark = find_landmark(tables, name);
  if (landmark.retired_s) {
    throw UserError(fmt::format("'{}' is forgotten already\n    '{}' brings it back", name,
                                "striate memory FILE restore " + shell_word(name)));
  }
  landmark.retired_s = tables.sessions.operating_now_s();
  landmark.retired_why = why;
  tables.landmarks.update(landmark);
  note(tables, "forgotten", name, why);
}

void restore(MemoryTables& tables, const std::string& name) {
  Landmark landmark = find_landmark(tables, name);
  if (!landmark.retired_s) throw UserError(fmt::format("'{}' is not forgotten", name));
  landmark.retired_s.reset();
  landmark.retired_why.clear();
  landmark.pinned = true;
  tables.landmarks.update(landmark);
  note(tables, "restored", name, "");
}

void rename(MemoryTables& tables, const std::string& name, const std::string& to) {
  const Landmark landmark = find_landmark(tables, name);
  check_landmark_name(to);
  if (tables.landmarks.find(to)) {
    throw UserError(
        fmt::format("'{}' is known already\n    forgotten landmarks keep their names, too; "
                    "'striate memory FILE list --all' lists all",
                    to));
  }
  tables.landmarks.rename(landmark.id, to, landmark.kind);
  tables.sessions.rename_landmark(name, to);
  note(tables, "renamed", to, fmt::format("'{}' before", name));
}

PrunePlan plan_prune(MemoryTables& tables, const LongTermSettings& settings) {
  const double now_s = tables.sessions.operating_now_s();
  PrunePlan plan;
  for (Landmark& landmark : tables.landmarks.all(true)) {
    if (landmark.retired_s) {
      const bool long_ago = now_s - *landmark.retired_s > settings.gone_after_s;
      if (long_ago && !landmark.pinned) plan.remove.push_back(landmark);
      continue;
    }
    landmark.retired_why = why_forgettable(landmark, now_s, settings);
    if (!landmark.retired_why.empty()) plan.retire.push_back(landmark);
  }
  plan.episodes = std::max(0, tables.sessions.count_episodes() - settings.most_episodes);
  return plan;
}

void prune(MemoryTables& tables, const PrunePlan& plan, const LongTermSettings& settings) {
  for (const Landmark& landmark : plan.retire) forget(tables, landmark.name, landmark.retired_why);
  for (const Landmark& landmark : plan.remove) {
    tables.landmarks.remove(landmark.id);
    note(tables, "removed", landmark.name, "retired long ago");
  }
  if (plan.episodes > 0) tables.sessions.keep_newest_episodes(settings.most_episodes);
}

}  // namespace striate::memory
