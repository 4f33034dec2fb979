#include "striate/agent/mission_memory.hpp"

#include <fmt/format.h>

#include <cmath>

#include "striate/agent/open_memory.hpp"
#include "striate/agent/simulated_body.hpp"
#include "striate/memory/localisation/map_keeping.hpp"
#include "striate/memory/long_term/learning.hpp"

namespace striate::agent {
namespace {

constexpr double kNoteTimeEvery_s = 60.0;  ///< what a crash may lose of the operating time
constexpr double kKeepMapEvery_s = 30.0;   ///< and of what was learned of places

/// Which session that was: task, and world or robot.
std::string session_title(const Mission& mission, const std::string& task) {
  if (mission.simulated() == nullptr) return fmt::format("{} with {}", task, mission.robot_file());
  return fmt::format("{} in {}, seed {}", task, mission.place(),
                     mission.simulated()->options().seed);
}

}  // namespace

MissionMemory::MissionMemory(const std::string& file, const Mission& mission,
                             const std::string& task) {
  if (file.empty()) return;
  settings_ = mission.settings().long_term_memory;
  const memory::MemoryOptions options = memory_options(memory::Access::session, "striate run");
  writer_ = std::make_unique<memory::MemoryWriter>(file, options);
  print_notices(writer_->notices());
  writer_->commit([&](memory::MemoryTables& tables) {
    session_ = tables.sessions.begin(memory::SessionKind::mission, software_name(),
                                     session_title(mission, task), options.now_unix_s);
    memory::Episode start;
    start.session = session_.id;
    start.time_s = session_.operating_start_s;
    start.kind = "start";
    start.text = session_.settings;
    tables.sessions.add(start);
  });
}

void MissionMemory::take(Mission& mission) {
  if (writer_ == nullptr) return;
  take(mission.cycle());
  if (mission.judge() != nullptr) take(*mission.judge());
}

void MissionMemory::take(CognitiveCycle& cycle) {
  now_ = cycle.trace().senses.now;
  pose_ = cycle.trace().senses.odometry.pose;
  take_map(cycle);
  keep_lessons(cycle.trace());
  if (const int stops = cycle.limiter().emergency_stops(); stops > emergency_stops_) {
    emergency_stops_ = stops;
    const std::string reason = name_of(cycle.trace().limited_by);
    note("emergency stop", reason, reason);
  }
  if (to_seconds(now_) - noted_s_ < kNoteTimeEvery_s) return;
  noted_s_ = to_seconds(now_);
  writer_->post([id = session_.id, now_s = noted_s_](memory::MemoryTables& tables) {
    tables.sessions.note_time(id, now_s);
  });
}

void MissionMemory::take(const simulator::Judge& judge) {
  for (; collisions_ < judge.collisions().size(); ++collisions_) {
    const std::string& hit = judge.collisions()[collisions_].hit;
    note("collision", hit, "touched " + hit);
  }
  for (; near_misses_ < judge.near_misses().size(); ++near_misses_) {
    const simulator::NearMiss& near = judge.near_misses()[near_misses_];
    note("near miss", near.to, fmt::format("{:.2f} m from {}", near.clearance_m, near.to));
  }
}

void MissionMemory::keep_lessons(const CycleTrace& trace) {
  for (const memory::LandmarkLesson& lesson : trace.lessons) {
    const bool seen = lesson.kind == memory::LandmarkLesson::Kind::recognised;
    memory::Episode episode = episode_now(seen ? "recognised" : "missed", "");
    episode.landmark = lesson.name;
    episode.text = !seen ? "not seen where it was expected"
                   : std::isfinite(lesson.distance_m)
                       ? fmt::format("{:.1f} m away, {:+.0f} deg", lesson.distance_m,
                                     degrees(lesson.bearing_rad))
                       : fmt::format("at {:+.0f} deg", degrees(lesson.bearing_rad));
    writer_->post([episode, seen, settings = settings_](memory::MemoryTables& tables) {
      if (seen) {
        memory::keep_sighting(tables, episode.landmark, episode.time_s, settings);
      } else {
        memory::keep_miss(tables, episode.landmark, settings);
      }
      tables.sessions.add(episode);
    });
  }
}

std::string MissionMemory::finish(Mission& mission, const RunResult& result) {
  if (writer_ == nullptr) return {};
  CognitiveCycle& cycle = mission.cycle();
  std::string lost;
  cycle.close_map(row_of(result.outcome).failed);
  try {
    writer_->commit([&](memory::MemoryTables& tables) {
      const double end_s = session_.operating_start_s + result.duration_s;
      for (memory::MapNews news = cycle.take_map_news(end_s); !news.empty();
           news = cycle.take_map_news(end_s)) {
        memory::keep_map(tables, news);
      }
      const std::string text = std::string(name_of(result.outcome)) +
                               (result.reason.empty() ? "" : ": " + result.reason);
      tables.sessions.add(episode_now("end", text));
      tables.sessions.end(session_.id, result.duration_s, text);
    });
  } catch (const std::exception& error) {
    lost = error.what();
  }
  if (writer_->lost() > 0) {
    if (!lost.empty()) lost += "\n";
    lost += fmt::format("{} episodes were not kept: {}", writer_->lost(), writer_->why_lost());
  }
  writer_.reset();
  return lost;
}

void MissionMemory::take_map(CognitiveCycle& cycle) {
  const double now_s = to_seconds(now_);
  if (now_s - map_kept_s_ < kKeepMapEvery_s) return;
  map_kept_s_ = now_s;
  memory::MapNews news = cycle.take_map_news(session_.operating_start_s + now_s);
  if (news.empty()) return;
  writer_->post(
      [news = std::move(news)](memory::MemoryTables& tables) { memory::keep_map(tables, news); });
}

memory::Episode MissionMemory::episode_now(const std::string& kind, const std::string& text) const {
  memory::Episode episode;
  episode.session = session_.id;
  episode.time_s = session_.operating_start_s + to_seconds(now_);
  episode.kind = kind;
  episode.x_m = pose_.x_m;
  episode.y_m = pose_.y_m;
  episode.heading_rad = pose_.heading_rad;
  episode.text = text;
  return episode;
}

void MissionMemory::note(const std::string& kind, const std::string& about,
                         const std::string& text) {
  const memory::Episode episode = episode_now(kind, text);
  const Point2 where{episode.x_m.value_or(0.0), episode.y_m.value_or(0.0)};
  if (!gate_.is_news(kind + " " + about, episode.time_s, where)) return;
  writer_->post([episode](memory::MemoryTables& tables) { tables.sessions.add(episode); });
}

}  // namespace striate::agent
