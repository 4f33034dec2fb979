#include "striate/memory/long_term/merged_sessions.hpp"

#include <algorithm>

namespace striate::memory {

int MergedSessions::take(SessionTable& ours, SessionTable& theirs) {
  theirs_ = theirs.all();
  std::reverse(theirs_.begin(), theirs_.end());
  match(ours.all());
  const double now_s = ours.operating_now_s();
  int taken = 0;
  for (Session session : theirs_) {
    if (was_known(session.id)) continue;
    if (taken++ == 0) shift_s_ = now_s - session.operating_start_s;
    if (session.state == SessionState::open) session.state = SessionState::closed;
    // Not taught here: undoing the last teaching must not reach it.
    if (session.kind == SessionKind::teach) session.kind = SessionKind::import;
    const std::int64_t id = session.id;
    session.operating_start_s += shift_s_;
    numbers_[id] = ours.adopt(session);
  }
  return taken;
}

/// Each of ours is one of theirs at most.
void MergedSessions::match(const std::vector<Session>& ours) {
  std::vector<Session> left(ours.rbegin(), ours.rend());
  for (const Session& session : theirs_) {
    const auto same = std::find_if(left.begin(), left.end(), [&](const Session& one) {
      return one.started_unix_s == session.started_unix_s && one.software == session.software &&
             one.settings == session.settings;
    });
    if (same == left.end()) continue;
    known_[session.id] = same->operating_start_s - session.operating_start_s;
    numbers_[session.id] = same->id;
    left.erase(same);
  }
}

std::int64_t MergedSessions::ours(std::int64_t theirs) const {
  const auto found = numbers_.find(theirs);
  return found == numbers_.end() ? 0 : found->second;
}

const Session* MergedSessions::session_at(double their_time_s) const {
  const Session* at = theirs_.empty() ? nullptr : &theirs_.front();
  for (const Session& session : theirs_) {
    if (session.operating_start_s <= their_time_s) at = &session;
  }
  return at;
}

bool MergedSessions::is_new(double their_time_s) const {
  const Session* session = session_at(their_time_s);
  return session == nullptr || !was_known(session->id);
}

double MergedSessions::our_time_s(double their_time_s) const {
  const Session* session = session_at(their_time_s);
  const auto known = session == nullptr ? known_.end() : known_.find(session->id);
  return their_time_s + (known == known_.end() ? shift_s_ : known->second);
}

}  // namespace striate::memory
