#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "striate/memory/long_term/records.hpp"
#include "striate/memory/long_term/session_table.hpp"

namespace striate::memory {

/// The sessions of two memories that become one, and with them what a time of the other is here.
class MergedSessions {
 public:
  /// Adopts those that are not known. The sessions of what was merged before are here already, and
  /// what belongs to them is known. The other's operating time goes on where ours has ended.
  /// @return how many were not known
  int take(SessionTable& ours, SessionTable& theirs);

  /// The number here of one of theirs.
  [[nodiscard]] std::int64_t ours(std::int64_t theirs) const;
  /// One of theirs that was here before.
  [[nodiscard]] bool was_known(std::int64_t theirs) const { return known_.contains(theirs); }
  /// The two memories have never met.
  [[nodiscard]] bool strangers() const { return known_.empty(); }

  /// Whether it happened in a session that came in now. Without sessions, all is taken for new.
  [[nodiscard]] bool is_new(double their_time_s) const;
  [[nodiscard]] double our_time_s(double their_time_s) const;

 private:
  void match(const std::vector<Session>& ours);
  [[nodiscard]] const Session* session_at(double their_time_s) const;

  std::vector<Session> theirs_;                             ///< the oldest first
  std::unordered_map<std::int64_t, std::int64_t> numbers_;  ///< theirs -> ours
  std::unordered_map<std::int64_t, double> known_;          ///< of theirs -> shift of its time
  double shift_s_ = 0.0;                                    ///< of the sessions that are new
};

}  // namespace striate::memory
