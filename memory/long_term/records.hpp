#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "striate/perception/recognition/landmark_view.hpp"

/// What the long-term memory holds, as the rest of the program sees it. One struct a table.
///
/// Times named `_s` are *operating time*: seconds that the robot was at work since its memory was
/// made. A night in the cupboard does not count. `unix_s` is the calendar's time.
namespace striate::memory {

enum class SessionKind { teach, mission, replay, import };
enum class SessionState { open, closed, crashed };
enum class LandmarkKind { taught, candidate };  ///< candidate: learned by itself, not named yet

/// A stretch of time in which one program wrote into the memory.
struct Session {
  std::int64_t id = 0;
  SessionKind kind = SessionKind::mission;
  SessionState state = SessionState::open;
  std::int64_t started_unix_s = 0;
  double operating_start_s = 0.0;
  double operating_s = 0.0;  ///< how long it lasted
  std::string software;      ///< "striate 0.1.0"
  std::string settings;      ///< what it was started with, in words
  std::string outcome;       ///< "success", "undone", ...; empty while open
};

using StoredDescriptor = std::array<std::uint8_t, 32>;  ///< 256 bits, bit b in byte b / 8

/// One look at a landmark.
struct StoredView {
  std::int64_t id = 0;
  std::int64_t landmark = 0;
  std::int64_t session = 0;
  double width_px = 0.0;
  double height_px = 0.0;
  std::vector<StoredDescriptor> descriptors;
  std::vector<perception::ViewKeypoint> keypoints;  ///< as many as descriptors
  std::optional<double> range_m;                    ///< from where it was seen
  std::optional<double> bearing_rad;
  std::vector<std::uint8_t> image;  ///< JPEG of the region; empty: none
  bool damaged = false;             ///< the bytes do not match their checksum: not to be used
};

/// Position on the map with its covariance.
struct MapPosition {
  double x_m = 0.0;
  double y_m = 0.0;
  double var_x_m2 = 0.0;
  double cov_xy_m2 = 0.0;
  double var_y_m2 = 0.0;
};

/// When something was used: how often, when first, and the last ten times, newest first.
struct UseHistory {
  static constexpr std::size_t kKept = 10;  ///< last uses kept exactly (Petrov 2006)
  std::int64_t uses = 0;
  double first_s = 0.0;
  std::vector<double> recent_s;
};

struct Landmark {
  std::int64_t id = 0;
  std::int64_t session = 0;  ///< in which it was learned
  std::string name;
  LandmarkKind kind = LandmarkKind::taught;
  std::optional<MapPosition> position;
  double strength = 0.5;  ///< in (0, 1): consolidation and enfeeblement
  UseHistory history;
  bool pinned = false;
  std::optional<double> retired_s;  ///< since when it is forgotten; it can be restored
  std::string retired_why;
  int views = 0;      ///< how many it has
  int keypoints = 0;  ///< of all of them
};

/// From one landmark to the next, as it was driven.
struct Route {
  std::int64_t from = 0;
  std::int64_t to = 0;
  double distance_m = 0.0;
  double turn_rad = 0.0;
  double distance_var_m2 = 0.0;
  double turn_var_rad2 = 0.0;
  std::int64_t successes = 0;
  std::int64_t failures = 0;
};

/// One cell of the allocentric obstacle grid, kObstacleCell_m wide.
struct ObstacleCell {
  int column = 0;  ///< x / kObstacleCell_m, rounded down
  int row = 0;     ///< y / kObstacleCell_m, rounded down
  double log_odds = 0.0;
  double seen_s = 0.0;
};
/// By hand: two patches of the short-term map each way.
inline constexpr double kObstacleCell_m = 0.10;

/// What happened, when and where.
struct Episode {
  std::int64_t id = 0;
  std::optional<std::int64_t> session;  ///< none: done by hand with `striate memory`
  double time_s = 0.0;
  std::string kind;  ///< "start", "end", "collision", "near miss", "emergency stop", "taught", ...
  std::optional<double> x_m, y_m, heading_rad;  ///< of the robot, as it believed
  std::string landmark;                         ///< its name; empty: none
  std::string text;
};

[[nodiscard]] const char* name_of(SessionKind kind);
[[nodiscard]] const char* name_of(SessionState state);
[[nodiscard]] const char* name_of(LandmarkKind kind);

}  // namespace striate::memory
