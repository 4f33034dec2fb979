#pragma once

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "striate/memory/long_term/records.hpp"

namespace striate::memory {

/// The tables `session` and `episode`. All errors are SQLite::Exception.
class SessionTable {
 public:
  explicit SessionTable(SQLite::Database& database);

  /// Operating time up to now: where the last session ended.
  [[nodiscard]] double operating_now_s();
  /// Starts a session at the operating time up to now. @return with id and start filled in.
  Session begin(SessionKind kind, const std::string& software, const std::string& settings,
                std::int64_t now_unix_s);
  /// How long it has lasted by now; what a crash would lose is the time since the last call.
  void note_time(std::int64_t id, double operating_s);
  void end(std::int64_t id, double operating_s, const std::string& outcome);
  void set_outcome(std::int64_t id, const std::string& outcome);
  /// The newest first.
  [[nodiscard]] std::vector<Session> all();
  /// Keeps a session of another memory as it is, under a new id, which is returned.
  std::int64_t adopt(const Session& session);

  std::int64_t add(const Episode& episode);
  /// The newest first. @param most at most so many; negative: all.
  [[nodiscard]] std::vector<Episode> episodes(int most);
  [[nodiscard]] int count_episodes();
  void keep_newest_episodes(int most);
  /// In all episodes about it.
  void rename_landmark(const std::string& from, const std::string& to);

 private:
  SQLite::Database& database_;
  SQLite::Statement now_, begin_, note_time_, end_, set_outcome_, all_, add_episode_, episodes_,
      rename_landmark_, count_episodes_, keep_newest_;
};

}  // namespace striate::memory
