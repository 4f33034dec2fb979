#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "striate/base/geometry.hpp"
#include "striate/base/time.hpp"
#include "striate/memory/short_term/local_grid.hpp"

namespace striate::memory {

/// What stopped the robot although no eye had seen it: an echo, a bump, a stall. The eyes go on
/// seeing free floor where a low box stands, so it is held against what they say for a while, or
/// the robot would try the same place again and again. Fixed memory.
class FeltThings {
 public:
  static constexpr std::size_t kMost = 128;  ///< by hand: six stops of a score of echoes
  /// By hand (README.md): backing out and going round a box takes ten seconds at 0.25 m/s; a person
  /// who was felt has long gone on, and must not shut a corridor much longer.
  static constexpr Duration kBelieved = std::chrono::seconds(30);

  /// @param place odometry frame. What was felt in that patch before is felt anew.
  void feel(Point2 place, TimePoint now);
  /// Writes what is still believed into the map; to be called after each image's evidence.
  void keep_in(LocalGrid& grid, TimePoint now);
  /// What lies under the robot is not there. @param inside whether a place, odometry frame, is
  template <class Inside>
  void forget_where(const Inside& inside) {
    for (std::size_t i = 0; i < count_;) {
      if (inside(things_[i].place)) {
        things_[i] = things_[--count_];
      } else {
        ++i;
      }
    }
  }
  [[nodiscard]] std::size_t count() const { return count_; }
  /// When something was felt last; nothing: never.
  [[nodiscard]] std::optional<TimePoint> last() const { return last_; }

 private:
  struct Thing {
    Point2 place;
    TimePoint felt{};
  };
  std::array<Thing, kMost> things_;
  std::size_t count_ = 0;
  std::optional<TimePoint> last_;
};

}  // namespace striate::memory
