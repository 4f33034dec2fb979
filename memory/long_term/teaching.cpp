#include "striate/memory/long_term/teaching.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "striate/base/plain_text.hpp"
#include "striate/base/user_error.hpp"
#include "striate/memory/long_term/activation.hpp"

namespace striate::memory {
namespace {

/// Of the landmarks under other names, the one that agrees best with any of the views.
std::string looks_like(MemoryTables& tables, const std::string& name,
                       const std::vector<StoredView>& views, ViewComparer& comparer,
                       const LongTermSettings& settings) {
  Agreement best;
  std::int64_t whose = 0;
  tables.views.for_each([&](const StoredView& old) {
    for (const StoredView& view : views) {
      const Agreement now = comparer.compare(view, old);
      if (now.inliers <= best.inliers) continue;
      best = now;
      whose = old.landmark;
    }
  });
  if (best.inliers < settings.alike_inliers) return "";
  for (const Landmark& landmark : tables.landmarks.all(false)) {
    if (landmark.id != whose || landmark.name == name) continue;
    return fmt::format(
        "looks like '{}': {} keypoints agree ({:.0f} %); if it is the same thing, "
        "undo this and teach it under that name",
        landmark.name, best.inliers, 100.0 * best.share);
  }
  return "";
}

void check_structure(const std::vector<StoredView>& views, const LongTermSettings& settings,
                     std::vector<std::string>& remarks) {
  for (std::size_t k = 0; k < views.size(); ++k) {
    const int count = static_cast<int>(views[k].keypoints.size());
    if (count < settings.least_keypoints) {
      throw UserError(
          fmt::format("view {} has too little structure: {} keypoints, at least {} are "
                      "needed to recognise anything; nothing was kept\n    take a "
                      "sharper or larger image, or one of a side with print on it",
                      k + 1, count, settings.least_keypoints));
    }
    if (count < settings.few_keypoints) {
      remarks.push_back(
          fmt::format("view {} has little structure: {} keypoints; it may not be "
                      "recognised from afar",
                      k + 1, count));
    }
  }
}

/// The landmark of that name: made, restored, or as it is.
Landmark landmark_for(MemoryTables& tables, const Session& session, const std::string& name,
                      const LongTermSettings& settings, Taught& taught) {
  std::optional<Landmark> known = tables.landmarks.find(name);
  if (!known) {
    taught.is_new = true;
    Landmark made;
    made.session = session.id;
    made.name = name;
    made.strength = settings.start_strength;
    note_use(made.history, session.operating_start_s);
    made.id = tables.landmarks.add(made);
    return made;
  }
  taught.restored = known->retired_s.has_value();
  known->retired_s.reset();
  known->retired_why.clear();
  note_use(known->history, session.operating_start_s);
  tables.landmarks.update(*known);
  if (known->kind == LandmarkKind::candidate) {
    tables.landmarks.rename(known->id, name, LandmarkKind::taught);
  }
  return *known;
}

/// Of two alike views the one with fewer keypoints goes.
void merge_most_alike(MemoryTables& tables, const std::vector<StoredView>& views,
                      ViewComparer& comparer) {
  double best_share = -1.0;
  std::int64_t goes = 0;
  for (std::size_t i = 0; i < views.size(); ++i) {
    for (std::size_t j = i + 1; j < views.size(); ++j) {
      const double share = comparer.compare(views[i], views[j]).share;
      if (share <= best_share) continue;
      best_share = share;
      const bool first_is_poorer = views[i].keypoints.size() < views[j].keypoints.size();
      goes = first_is_poorer ? views[i].id : views[j].id;
    }
  }
  tables.views.remove(goes);
}

}  // namespace

void check_landmark_name(const std::string& name) {
  const bool shape =
      !name.empty() && name.size() <= 64 && name.front() != ' ' && name.back() != ' ';
  if (shape && is_plain_text(name)) return;
  throw UserError(
      fmt::format("'{}' is no name for a landmark\n    1 to 64 bytes of UTF-8 that a terminal "
                  "shows as they are: "
                  "no line breaks, control characters or blanks at its ends",
                  plain_text(name)));
}

bool are_alike(const StoredView& a, const StoredView& b, ViewComparer& comparer,
               const LongTermSettings& settings) {
  // Made from the same image, also where too few keypoints are left to agree on a pose.
  if (a.descriptors == b.descriptors && a.keypoints == b.keypoints) return true;
  const Agreement agreement = comparer.compare(a, b);
  return agreement.inliers >= settings.alike_inliers && agreement.share >= settings.alike_share;
}

bool add_view(MemoryTables& tables, const StoredView& view, ViewComparer& comparer,
              const LongTermSettings& settings) {
  std::vector<StoredView> old = tables.views.of(view.landmark);
  for (const StoredView& one : old) {
    // The old one stays: so the teaching can be undone.
    if (are_alike(view, one, comparer, settings)) return false;
  }
  tables.views.add(view);
  if (static_cast<int>(old.size()) < settings.most_views) return true;
  merge_most_alike(tables, tables.views.of(view.landmark), comparer);
  return false;
}

Taught teach(MemoryTables& tables, const Session& session, const std::string& name,
             const std::vector<StoredView>& views, const LongTermSettings& settings) {
  check_landmark_name(name);
  if (views.empty()) throw UserError(fmt::format("no image to learn '{}' from", name));
  Taught taught;
  check_structure(views, settings, taught.remarks);
  ViewComparer comparer;
  const std::string like = looks_like(tables, name, views, comparer, settings);
  if (!like.empty()) taught.remarks.push_back(like);
  const Landmark landmark = landmark_for(tables, session, name, settings, taught);
  for (StoredView view : views) {
    view.landmark = landmark.id;
    view.session = session.id;
    const bool one_more = add_view(tables, view, comparer, settings);
    ++(one_more ? taught.added : taught.merged);
  }
  Episode episode;
  episode.session = session.id;
  episode.time_s = session.operating_start_s;
  episode.kind = "taught";
  episode.landmark = name;
  episode.text = fmt::format("views: {} added, {} like known ones", taught.added, taught.merged);
  tables.sessions.add(episode);
  return taught;
}

std::string undo_teaching(MemoryTables& tables) {
  for (const Session& session : tables.sessions.all()) {
    if (session.kind != SessionKind::teach || session.outcome == "undone") continue;
    const int views = tables.views.count_of_session(session.id);
    tables.views.remove_of_session(session.id);
    tables.sessions.set_outcome(session.id, "undone");
    if (views == 0) {
      return fmt::format("session {} ({}) undone: nothing of it was there to take back", session.id,
                         session.settings);
    }
    return fmt::format("session {} ({}) undone: {} view{} taken back", session.id, session.settings,
                       views, views == 1 ? "" : "s");
  }
  throw UserError("no teaching is left to undo");
}

}  // namespace striate::memory
