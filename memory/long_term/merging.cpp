#include "striate/memory/long_term/merging.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <unordered_map>

#include "striate/base/index_within.hpp"
#include "striate/base/shell_text.hpp"
#include "striate/memory/long_term/map_alignment.hpp"
#include "striate/memory/long_term/merged_sessions.hpp"
#include "striate/memory/long_term/teaching.hpp"

namespace striate::memory {
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
  }

  Merged run() {
    merged_.sessions = sessions_.take(tables_.sessions, other_.sessions);
    for (const Landmark& landmark : other_.landmarks.all(true)) take(landmark);
    take_routes();
    take_map();
    take_episodes();
    return merged_;
  }

 private:
  void take(const Landmark& landmark) {
    const std::vector<StoredView> views = other_.views.of(landmark.id);
    std::optional<Landmark> same = tables_.landmarks.find(landmark.name);
    if (!same) same = find_alike(views);
    if (same && same->name != landmark.name) {
      merged_.remarks.push_back(fmt::format(
          "'{}' is what is known here as '{}': both are kept as that", landmark.name, same->name));
    }
    if (same && same->name == landmark.name) tell_if_different(*same, views);
    ++(same ? merged_.joined : merged_.added);
    landmarks_[landmark.id] = same ? join(*same, landmark) : add(landmark);
    const bool full =
        same && static_cast<int>(tables_.views.of(same->id).size()) >= settings_.most_views;
    for (StoredView view : views) {
      // It had its chance when that session was merged: now it would only push others out again.
      if (full && sessions_.was_known(view.session)) continue;
      if (view.damaged) {
        ++merged_.damaged;
        continue;
      }
      view.landmark = landmarks_[landmark.id];
      view.session = sessions_.ours(view.session);
      if (!same) {
        tables_.views.add(view);
        ++merged_.views;
      } else if (add_view(tables_, view, comparer_, settings_)) {
        ++merged_.views;
      }
    }
  }

  /// Two sides of one thing have nothing in common either, so the name decides, but not in silence.
  void tell_if_different(const Landmark& ours, const std::vector<StoredView>& theirs) {
    int compared = 0;
    for (const StoredView& mine : tables_.views.of(ours.id)) {
      for (const StoredView& view : theirs) {
        if (mine.damaged || view.damaged) continue;
        ++compared;
        if (are_alike(mine, view, comparer_, settings_)) return;
        if (comparer_.compare(view, mine).inliers >= settings_.alike_inliers) return;
      }
    }
    if (compared == 0) return;
    merged_.remarks.push_back(
        fmt::format("'{}': no view of the one looks like any view of the other; if they are two "
                    "things, take the "
                    "copy back and rename one first: striate memory FILE rename {} NEW",
                    ours.name, shell_word(ours.name)));
  }

  std::optional<Landmark> find_alike(const std::vector<StoredView>& views) {
    Agreement best;
    std::int64_t whose = 0;
    // What came from the other memory a moment ago was told apart there by a person.
    const auto compare = [&](const StoredView& ours) {
      for (const StoredView& view : views) {
        const Agreement now = comparer_.compare(view, ours);
        if (now.inliers <= best.inliers || now.share < settings_.alike_share) continue;
        best = now;
        whose = ours.landmark;
      }
    };
    tables_.views.for_each(compare, last_view_);
    if (best.inliers < settings_.alike_inliers) return std::nullopt;
    for (const Landmark& landmark : tables_.landmarks.all(false)) {
      if (landmark.id == whose) return landmark;
    }
    return std::nullopt;
  }

  std::int64_t add(Landmark landmark) {
    landmark.session = sessions_.ours(landmark.session);
    if (landmark.position && has_map_) to_place_.push_back({landmark.name, *landmark.position});
    if (has_map_) landmark.position.reset();
    shift(landmark);
    return tables_.landmarks.add(landmark);
  }

  /// Both histories become one, without what was known before; the stronger opinion counts.
  std::int64_t join(Landmark ours, Landmark theirs) {
    join_histories(ours.history, theirs.history);
    shift(theirs);
    ours.strength = std::max(ours.strength, theirs.strength);
    ours.pinned = ours.pinned || theirs.pinned;
    if (!theirs.retired_s && merged_.sessions > 0) {
      ours.retired_s.reset();
      ours.retired_why.clear();
    }
    if (theirs.position && ours.position) {
      common_.push_back({*theirs.position, *ours.position});
    } else if (theirs.position && has_map_) {
      to_place_.push_back({ours.name, *theirs.position});
    } else if (theirs.position) {
      ours.position = theirs.position;
    }
    tables_.landmarks.update(ours);
    if (ours.kind == LandmarkKind::candidate && theirs.kind == LandmarkKind::taught) {
      tables_.landmarks.rename(ours.id, ours.name, LandmarkKind::taught);
    }
    return ours.id;
  }

  void join_histories(UseHistory& ours, const UseHistory& theirs) const {
    std::int64_t new_uses = 0;
    for (const double time_s : theirs.recent_s) {
      if (!sessions_.is_new(time_s)) continue;
      ++new_uses;
      ours.recent_s.push_back(sessions_.our_time_s(time_s));
    }
    std::sort(ours.recent_s.begin(), ours.recent_s.end(), std::greater<>());
    if (ours.recent_s.size() > UseHistory::kKept) ours.recent_s.resize(UseHistory::kKept);
    // Of memories that have met before, only the uses whose time is known can be told apart.
    ours.uses += sessions_.strangers() ? theirs.uses : new_uses;
    if (sessions_.strangers())
      ours.first_s = std::min(ours.first_s, sessions_.our_time_s(theirs.first_s));
  }

  void shift(Landmark& landmark) const {
    landmark.history.first_s = sessions_.our_time_s(landmark.history.first_s);
    for (double& time_s : landmark.history.recent_s) time_s = sessions_.our_time_s(time_s);
    if (landmark.retired_s) landmark.retired_s = sessions_.our_time_s(*landmark.retired_s);
  }

  void take_routes() {
    for (Route route : other_.places.routes()) {
      route.from = landmarks_[route.from];
      route.to = landmarks_[route.to];
      if (route.from == route.to) continue;
      tables_.places.put(joined_with_ours(route));
    }
  }

  /// Where both have a map, theirs is put on ours by the landmarks that are on both.
  void take_map() {
    std::vector<ObstacleCell> cells = other_.places.cells();
    Pose2 origin;
    if (has_map_) {
      const std::optional<Pose2> aligned = align_maps(common_);
      if (!aligned) {
        say_what_is_left_out(cells);
        return;
      }
      origin = *aligned;
    }
    for (const auto& [name, at] : to_place_) {
      const std::optional<Landmark> landmark = tables_.landmarks.find(name);
      if (landmark) tables_.landmarks.set_position(landmark->id, on_our_map(origin, at));
    }
    std::set<std::pair<int, int>> ours;
    for (const ObstacleCell& cell : tables_.places.cells()) ours.insert({cell.row, cell.column});
    for (ObstacleCell& cell : cells) {
      if (has_map_) move(cell, origin);
      if (ours.contains({cell.row, cell.column})) continue;
      cell.seen_s = sessions_.our_time_s(cell.seen_s);
      tables_.places.put(cell);
    }
  }

  static void move(ObstacleCell& cell, const Pose2& origin) {
    const Point2 middle = transform(
        origin, Point2{(cell.column + 0.5) * kObstacleCell_m, (cell.row + 0.5) * kObstacleCell_m});
    cell.column = cell_below(middle.x_m / kObstacleCell_m);
    cell.row = cell_below(middle.y_m / kObstacleCell_m);
  }

  void say_what_is_left_out(const std::vector<ObstacleCell>& cells) {
    if (to_place_.empty() && (cells.empty() || merged_.sessions == 0)) return;
    merged_.remarks.push_back(fmt::format(
        "{} positions and {} obstacle cells of the other memory were left out: its map has another "
        "origin, and fewer than two landmarks lie on both maps alike",
        to_place_.size(), cells.size()));
  }

  Route joined_with_ours(const Route& theirs) {
    for (Route ours : tables_.places.routes()) {
      if (ours.from != theirs.from || ours.to != theirs.to) continue;
      Route joined = theirs.distance_var_m2 < ours.distance_var_m2 ? theirs : ours;
      // Of memories that have met before, some drives are in both counts.
      const bool strangers = sessions_.strangers();
      joined.successes = strangers ? ours.successes + theirs.successes
                                   : std::max(ours.successes, theirs.successes);
      joined.failures =
          strangers ? ours.failures + theirs.failures : std::max(ours.failures, theirs.failures);
      return joined;
    }
    return theirs;
  }

  void take_episodes() {
    std::vector<Episode> episodes = other_.sessions.episodes(-1);
    std::reverse(episodes.begin(), episodes.end());
    for (Episode episode : episodes) {
      const bool known =
          episode.session ? sessions_.was_known(*episode.session) : !sessions_.strangers();
      if (known) continue;
      episode.time_s = sessions_.our_time_s(episode.time_s);
      if (episode.session) episode.session = sessions_.ours(*episode.session);
      tables_.sessions.add(episode);
    }
  }

  MemoryTables& tables_;
  MemoryTables& other_;
  const LongTermSettings& settings_;
  ViewComparer comparer_;
  MergedSessions sessions_;
  Ids landmarks_;
  Merged merged_;
  std::int64_t last_view_ = 0;  ///< of those that are ours
  bool has_map_ = false;
  std::vector<OnBothMaps> common_;
  std::vector<std::pair<std::string, MapPosition>> to_place_;  ///< theirs, by our name
};

}  // namespace

Merged merge(MemoryTables& tables, MemoryTables& other, const LongTermSettings& settings) {
  return Merger(tables, other, settings).run();
}

}  // namespace striate::memory
