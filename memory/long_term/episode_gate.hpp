#pragma once

#include <cmath>
#include <map>
#include <string>

#include "striate/base/geometry.hpp"

namespace striate::memory {

/// What happens again at the same place a moment later is one episode: a robot that stands before
/// something must not fill its memory with it.
class EpisodeGate {
 public:
  /// @return whether it is news: another kind, half a metre further, or a minute later.
  [[nodiscard]] bool is_news(const std::string& kind, double now_s, const Point2& where) {
    const auto [last, first] = last_.try_emplace(kind, Last{now_s, where});
    if (first) return true;
    const double moved_m =
        std::hypot(where.x_m - last->second.where.x_m, where.y_m - last->second.where.y_m);
    if (moved_m < kSamePlace_m && now_s - last->second.time_s < kSameTime_s) return false;
    last->second = {now_s, where};
    return true;
  }

 private:
  static constexpr double kSamePlace_m = 0.5;  ///< by hand: a robot's length
  static constexpr double kSameTime_s = 60.0;  ///< by hand: a line a minute at most
  struct Last {
    double time_s;
    Point2 where;
  };
  std::map<std::string, Last> last_;
};

}  // namespace striate::memory
