#include "striate/memory/long_term/session_table.hpp"

#include "striate/base/plain_text.hpp"
#include "striate/memory/long_term/statement_use.hpp"

namespace striate::memory {
namespace {

SessionKind kind_of(const std::string& name) {
  for (const SessionKind kind : {SessionKind::teach, SessionKind::mission, SessionKind::replay}) {
    if (name == name_of(kind)) return kind;
  }
  return SessionKind::import;
}

SessionState state_of(const std::string& name) {
  if (name == name_of(SessionState::open)) return SessionState::open;
  return name == name_of(SessionState::closed) ? SessionState::closed : SessionState::crashed;
}

}  // namespace

SessionTable::SessionTable(SQLite::Database& database)
    : database_(database),
      now_(database, "SELECT coalesce(max(operating_start_s + operating_s), 0.0) FROM session"),
      begin_(database,
             "INSERT INTO session (kind, state, started_unix_s, operating_start_s, operating_s, "
             "software, settings, outcome) VALUES (?, ?, ?, ?, ?, ?, ?, ?)"),
      note_time_(database, "UPDATE session SET operating_s = ? WHERE id = ?"),
      end_(database,
           "UPDATE session SET operating_s = ?, state = 'closed', outcome = ? WHERE id = ?"),
      set_outcome_(database, "UPDATE session SET outcome = ? WHERE id = ?"),
      all_(database,
           "SELECT id, kind, state, started_unix_s, operating_start_s, operating_s, software, "
           "settings, outcome FROM session ORDER BY id DESC"),
      add_episode_(database,
                   "INSERT INTO episode (session, time_s, kind, x_m, y_m, heading_rad, landmark, "
                   "text) VALUES (?, ?, ?, ?, ?, ?, ?, ?)"),
      episodes_(database,
                "SELECT id, session, time_s, kind, x_m, y_m, heading_rad, landmark, text "
                "FROM episode ORDER BY id DESC LIMIT ?"),
      rename_landmark_(database, "UPDATE episode SET landmark = ? WHERE landmark = ?"),
      count_episodes_(database, "SELECT count(*) FROM episode"),
      keep_newest_(database,
                   "DELETE FROM episode WHERE id NOT IN "
                   "(SELECT id FROM episode ORDER BY id DESC LIMIT ?)") {}

void SessionTable::rename_landmark(const std::string& from, const std::string& to) {
  StatementUse(rename_landmark_).with(to).with(from).run();
}

double SessionTable::operating_now_s() {
  StatementUse use(now_);
  return use.next() ? use.column(0).getDouble() : 0.0;
}

Session SessionTable::begin(SessionKind kind, const std::string& software,
                            const std::string& settings, std::int64_t now_unix_s) {
  Session session;
  session.kind = kind;
  session.started_unix_s = now_unix_s;
  session.operating_start_s = operating_now_s();
  session.software = software;
  session.settings = settings;
  session.id = adopt(session);
  return session;
}

std::int64_t SessionTable::adopt(const Session& session) {
  StatementUse use(begin_);
  use.with(std::string(name_of(session.kind))).with(std::string(name_of(session.state)));
  use.with(session.started_unix_s).with(session.operating_start_s).with(session.operating_s);
  use.with(session.software).with(session.settings).with(session.outcome).run();
  return database_.getLastInsertRowid();
}

void SessionTable::note_time(std::int64_t id, double operating_s) {
  StatementUse(note_time_).with(operating_s).with(id).run();
}

void SessionTable::end(std::int64_t id, double operating_s, const std::string& outcome) {
  StatementUse(end_).with(operating_s).with(outcome).with(id).run();
}

void SessionTable::set_outcome(std::int64_t id, const std::string& outcome) {
  StatementUse(set_outcome_).with(outcome).with(id).run();
}

std::vector<Session> SessionTable::all() {
  StatementUse use(all_);
  std::vector<Session> sessions;
  while (use.next()) {
    Session session;
    session.id = use.column(0).getInt64();
    session.kind = kind_of(use.column(1).getString());
    session.state = state_of(use.column(2).getString());
    session.started_unix_s = use.column(3).getInt64();
    session.operating_start_s = use.column(4).getDouble();
    session.operating_s = use.column(5).getDouble();
    session.software = plain_text(use.column(6).getString());
    session.settings = plain_text(use.column(7).getString());
    session.outcome = plain_text(use.column(8).getString());
    sessions.push_back(std::move(session));
  }
  return sessions;
}

std::int64_t SessionTable::add(const Episode& episode) {
  StatementUse use(add_episode_);
  use.with(episode.session).with(episode.time_s).with(episode.kind);
  use.with(episode.x_m).with(episode.y_m).with(episode.heading_rad);
  use.with(episode.landmark).with(episode.text).run();
  return database_.getLastInsertRowid();
}

std::vector<Episode> SessionTable::episodes(int most) {
  StatementUse use(episodes_);
  use.with(most);
  std::vector<Episode> episodes;
  while (use.next()) {
    Episode episode;
    episode.id = use.column(0).getInt64();
    if (!use.column(1).isNull()) episode.session = use.column(1).getInt64();
    episode.time_s = use.column(2).getDouble();
    episode.kind = plain_text(use.column(3).getString());
    episode.x_m = use.maybe(4);
    episode.y_m = use.maybe(5);
    episode.heading_rad = use.maybe(6);
    episode.landmark = plain_text(use.column(7).getString());
    episode.text = plain_text(use.column(8).getString());
    episodes.push_back(std::move(episode));
  }
  return episodes;
}

int SessionTable::count_episodes() {
  StatementUse use(count_episodes_);
  return use.next() ? use.column(0).getInt() : 0;
}

void SessionTable::keep_newest_episodes(int most) {
  StatementUse(keep_newest_).with(most).run();
}

}  // namespace striate::memory
