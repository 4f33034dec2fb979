#include "app/mission_memory.hpp"

#include <fmt/format.h>

#include <cmath>

#include "app/memory/open_memory.hpp"
#include "config/user_error.hpp"
#include "memory/long_term/learning.hpp"
#include "memory/place/place_keeping.hpp"

namespace striate {
namespace {

constexpr double kNoteTimeEvery_s = 60.0;    ///< what a crash may lose of the operating time
constexpr double kKeepPlacesEvery_s = 30.0;  ///< and of what was learned of places

}  // namespace

MissionMemory::MissionMemory(const std::string& file, const MissionOptions& mission) {
  if (file.empty()) return;
  settings_ = load_robot_settings(mission.robot).long_term_memory;
  const MemoryOptions options = memory_options(Access::session, "striate run");
  writer_ = std::make_unique<MemoryWriter>(file, options);
  print_notices(writer_->notices());
  writer_->commit([&](MemoryTables& tables) {
    session_ = tables.sessions.begin(
        SessionKind::mission, software_name(),
        fmt::format("{} in {}, seed {}", mission.task, mission.world, mission.seed),
        options.now_unix_s);
    Episode start;
    start.session = session_.id;
    start.time_s = session_.operating_start_s;
    start.kind = "start";
    start.text = session_.settings;
    tables.sessions.add(start);
  });
}

void MissionMemory::take(Mission& mission) {
  if (writer_ == nullptr) return;
  take_places(mission);
  keep_lessons(mission);
  const auto& collisions = mission.body().judge().collisions();
  for (; collisions_ < collisions.size(); ++collisions_) {
    const std::string& hit = collisions[collisions_].hit;
    note(mission, "collision", hit, "touched " + hit);
  }
  const auto& near_misses = mission.body().judge().near_misses();
  for (; near_misses_ < near_misses.size(); ++near_misses_) {
    const simulator::NearMiss& near = near_misses[near_misses_];
    note(mission, "near miss", near.to, fmt::format("{:.2f} m from {}", near.clearance_m, near.to));
  }
  if (const int stops = mission.cycle().limiter().emergency_stops(); stops > emergency_stops_) {
    emergency_stops_ = stops;
    const std::string reason = name_of(mission.cycle().limiter().reason());
    note(mission, "emergency stop", reason, reason);
  }
  const double now_s = to_seconds(mission.cycle().trace().senses.now);
  if (now_s - noted_s_ < kNoteTimeEvery_s) return;
  noted_s_ = now_s;
  writer_->post(
      [id = session_.id, now_s](MemoryTables& tables) { tables.sessions.note_time(id, now_s); });
}

void MissionMemory::keep_lessons(const Mission& mission) {
  for (const LandmarkLesson& lesson : mission.cycle().trace().lessons) {
    const bool seen = lesson.kind == LandmarkLesson::Kind::recognised;
    Episode episode = episode_now(mission, seen ? "recognised" : "missed", "");
    episode.landmark = lesson.name;
    episode.text = !seen ? "not seen where it was expected"
                   : std::isfinite(lesson.distance_m)
                       ? fmt::format("{:.1f} m away, {:+.0f} deg", lesson.distance_m,
                                     degrees(lesson.bearing_rad))
                       : fmt::format("at {:+.0f} deg", degrees(lesson.bearing_rad));
    writer_->post([episode, seen, settings = settings_](MemoryTables& tables) {
      if (seen) {
        keep_sighting(tables, episode.landmark, episode.time_s, settings);
      } else {
        keep_miss(tables, episode.landmark, settings);
      }
      tables.sessions.add(episode);
    });
  }
}

void MissionMemory::finish(Mission& mission, const RunResult& result) {
  if (writer_ == nullptr) return;
  mission.cycle().close_places(result.outcome != "success" && result.outcome != "interrupted");
  try {
    writer_->commit([&](MemoryTables& tables) {
      const double end_s = session_.operating_start_s + result.duration_s;
      for (PlaceNews news = mission.cycle().take_place_news(end_s); !news.empty();
           news = mission.cycle().take_place_news(end_s)) {
        keep_places(tables, news);
      }
      const std::string text = result.outcome + (result.reason.empty() ? "" : ": " + result.reason);
      tables.sessions.add(episode_now(mission, "end", text));
      tables.sessions.end(session_.id, result.duration_s, text);
    });
  } catch (const UserError& error) {
    fmt::print(stderr, "{}\n", error.what());
  }
  if (writer_->lost() > 0) {
    fmt::print(stderr, "{} episodes were not kept: {}\n", writer_->lost(), writer_->why_lost());
  }
  writer_.reset();
}

void MissionMemory::take_places(Mission& mission) {
  const double now_s = to_seconds(mission.cycle().trace().senses.now);
  if (now_s - places_kept_s_ < kKeepPlacesEvery_s) return;
  places_kept_s_ = now_s;
  PlaceNews news = mission.cycle().take_place_news(session_.operating_start_s + now_s);
  if (news.empty()) return;
  writer_->post([news = std::move(news)](MemoryTables& tables) { keep_places(tables, news); });
}

Episode MissionMemory::episode_now(const Mission& mission, const std::string& kind,
                                   const std::string& text) const {
  const Senses& senses = mission.cycle().trace().senses;
  Episode episode;
  episode.session = session_.id;
  episode.time_s = session_.operating_start_s + to_seconds(senses.now);
  episode.kind = kind;
  episode.x_m = senses.odometry.pose.x_m;
  episode.y_m = senses.odometry.pose.y_m;
  episode.heading_rad = senses.odometry.pose.heading_rad;
  episode.text = text;
  return episode;
}

void MissionMemory::note(const Mission& mission, const std::string& kind, const std::string& about,
                         const std::string& text) {
  const Episode episode = episode_now(mission, kind, text);
  const Point2 where{episode.x_m.value_or(0.0), episode.y_m.value_or(0.0)};
  if (!gate_.is_news(kind + " " + about, episode.time_s, where)) return;
  writer_->post([episode](MemoryTables& tables) { tables.sessions.add(episode); });
}

}  // namespace striate
