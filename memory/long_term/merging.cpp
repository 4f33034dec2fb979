#include "memory/long_term/merging.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <unordered_map>

#include "memory/long_term/teaching.hpp"

namespace striate {
namespace {

using Ids = std::unordered_map<std::int64_t, std::int64_t>;  ///< of the other memory -> here

class Merger {
 public:
  Merger(MemoryTables& tables, MemoryTables& other, const LongTermSettings& settings)
      : tables_(tables), other_(other), settings_(settings) {
    const std::vector<Landmark> ours = tables_.landmarks.all(true);
    has_map_ = !tables_.places.cells().empty() ||
               std::any_of(ours.begin(), ours.end(), [](auto& one) { return one.position; });
    tables_.views.for_each(
        [&](const StoredView& view) { last_view_ = std::max(last_view_, view.id); });
    // The other's operating time goes on where ours has ended.
    shift_s_ = tables_.sessions.all().empty() ? 0.0 : tables_.sessions.operating_now_s();
  }

  Merged run() {
    take_sessions();
    for (const Landmark& landmark : other_.landmarks.all(true)) take(landmark);
    take_places();
    take_episodes();
    return merged_;
  }

 private:
  void take_sessions() {
    std::vector<Session> sessions = other_.sessions.all();
    std::reverse(sessions.begin(), sessions.end());
    for (Session session : sessions) {
      if (session.state == SessionState::open) session.state = SessionState::closed;
      // Not taught here: undoing the last teaching must not reach it.
      if (session.kind == SessionKind::teach) session.kind = SessionKind::import;
      const std::int64_t id = session.id;
      session.operating_start_s += shift_s_;
      sessions_[id] = tables_.sessions.adopt(session);
    }
  }

  void take(const Landmark& landmark) {
    const std::vector<StoredView> views = other_.views.of(landmark.id);
    std::optional<Landmark> same = tables_.landmarks.find(landmark.name);
    if (!same) same = find_alike(views);
    if (same && same->name != landmark.name) {
      merged_.remarks.push_back(fmt::format(
          "'{}' is what is known here as '{}': both are kept as that", landmark.name, same->name));
    }
    ++(same ? merged_.joined : merged_.added);
    landmarks_[landmark.id] = same ? join(*same, landmark) : add(landmark);
    for (StoredView view : views) {
      if (view.damaged) {
        ++merged_.damaged;
        continue;
      }
      view.landmark = landmarks_[landmark.id];
      view.session = sessions_[view.session];
      if (!same) {
        tables_.views.add(view);
        ++merged_.views;
      } else if (add_view(tables_, view, comparer_, settings_)) {
        ++merged_.views;
      }
    }
  }

  std::optional<Landmark> find_alike(const std::vector<StoredView>& views) {
    Agreement best;
    std::int64_t whose = 0;
    tables_.views.for_each([&](const StoredView& ours) {
      // What came from the other memory a moment ago was told apart there by a person.
      if (ours.id > last_view_) return;
      for (const StoredView& view : views) {
        const Agreement now = comparer_.compare(view, ours);
        if (now.inliers <= best.inliers || now.share < settings_.alike_share) continue;
        best = now;
        whose = ours.landmark;
      }
    });
    if (best.inliers < settings_.alike_inliers) return std::nullopt;
    for (const Landmark& landmark : tables_.landmarks.all(false)) {
      if (landmark.id == whose) return landmark;
    }
    return std::nullopt;
  }

  std::int64_t add(Landmark landmark) {
    landmark.session = sessions_[landmark.session];
    shift(landmark);
    if (has_map_) landmark.position.reset();
    return tables_.landmarks.add(landmark);
  }

  /// Both histories become one; the stronger opinion counts.
  std::int64_t join(Landmark ours, Landmark theirs) {
    shift(theirs);
    std::vector<double>& recent_s = ours.history.recent_s;
    recent_s.insert(recent_s.end(), theirs.history.recent_s.begin(), theirs.history.recent_s.end());
    std::sort(recent_s.begin(), recent_s.end(), std::greater<>());
    if (recent_s.size() > UseHistory::kKept) recent_s.resize(UseHistory::kKept);
    ours.history.uses += theirs.history.uses;
    ours.history.first_s = std::min(ours.history.first_s, theirs.history.first_s);
    ours.strength = std::max(ours.strength, theirs.strength);
    ours.pinned = ours.pinned || theirs.pinned;
    if (!theirs.retired_s) {
      ours.retired_s.reset();
      ours.retired_why.clear();
    }
    if (!has_map_ && !ours.position) ours.position = theirs.position;
    tables_.landmarks.update(ours);
    if (ours.kind == LandmarkKind::candidate && theirs.kind == LandmarkKind::taught) {
      tables_.landmarks.rename(ours.id, ours.name, LandmarkKind::taught);
    }
    return ours.id;
  }

  void shift(Landmark& landmark) const {
    landmark.history.first_s += shift_s_;
    for (double& time_s : landmark.history.recent_s) time_s += shift_s_;
    if (landmark.retired_s) *landmark.retired_s += shift_s_;
  }

  void take_places() {
    for (Route route : other_.places.routes()) {
      route.from = landmarks_[route.from];
      route.to = landmarks_[route.to];
      if (route.from == route.to) continue;
      tables_.places.put(joined_with_ours(route));
    }
    const std::vector<ObstacleCell> cells = other_.places.cells();
    if (has_map_) {
      const std::vector<Landmark> theirs = other_.landmarks.all(true);
      if (cells.empty() &&
          std::none_of(theirs.begin(), theirs.end(), [](auto& one) { return one.position; })) {
        return;
      }
      merged_.remarks.emplace_back(
          "positions and the obstacle grid of the other memory were left out: its map has another "
          "origin");
      return;
    }
    for (ObstacleCell cell : cells) {
      cell.seen_s += shift_s_;
      tables_.places.put(cell);
    }
  }

  Route joined_with_ours(const Route& theirs) {
    for (Route ours : tables_.places.routes()) {
      if (ours.from != theirs.from || ours.to != theirs.to) continue;
      if (theirs.distance_var_m2 < ours.distance_var_m2) {
        Route better = theirs;
        better.successes += ours.successes;
        better.failures += ours.failures;
        return better;
      }
      ours.successes += theirs.successes;
      ours.failures += theirs.failures;
      return ours;
    }
    return theirs;
  }

  void take_episodes() {
    std::vector<Episode> episodes = other_.sessions.episodes(-1);
    std::reverse(episodes.begin(), episodes.end());
    for (Episode episode : episodes) {
      if (episode.session) episode.session = sessions_[*episode.session];
      episode.time_s += shift_s_;
      tables_.sessions.add(episode);
    }
  }

  MemoryTables& tables_;
  MemoryTables& other_;
  const LongTermSettings& settings_;
  ViewComparer comparer_;
  Ids sessions_;
  Ids landmarks_;
  Merged merged_;
  std::int64_t last_view_ = 0;  ///< of those that are ours
  bool has_map_ = false;
  double shift_s_ = 0.0;
};

}  // namespace

Merged merge(MemoryTables& tables, MemoryTables& other, const LongTermSettings& settings) {
  return Merger(tables, other, settings).run();
}

}  // namespace striate
