#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>

#include "striate/base/fixed_text.hpp"
#include "striate/config/settings.hpp"
#include "striate/memory/localisation/localisation.hpp"
#include "striate/memory/short_term/blank_view.hpp"
#include "striate/memory/short_term/corridor_memory.hpp"
#include "striate/memory/short_term/felt_things.hpp"
#include "striate/memory/short_term/landmark_memory.hpp"
#include "striate/memory/short_term/local_grid.hpp"
#include "striate/memory/short_term/occupancy_updater.hpp"
#include "striate/memory/short_term/odometry_history.hpp"
#include "striate/memory/short_term/polar_map.hpp"
#include "striate/memory/short_term/salient_memory.hpp"
#include "striate/memory/short_term/trajectory.hpp"
#include "striate/platform/interface/robot.hpp"

namespace striate::memory {

/// Ours: the literature gives no constants.
///
/// By hand (README.md, "Where the numbers come from"), tuned in the flat test world.
struct ShortTermMemorySettings {
  double free_fades_s = 30.0;      ///< log-odds of -3 are free for 54 s: floor within a minute
  double occupied_fades_s = 90.0;  ///< log-odds of 3.5 block for 96 s
  double moving_fades_s = 3.5;     ///< log-odds of 3.5 block for 3.7 s: a person has walked 3 m
  double blur_after_s = 4.0;
  double blur_every_m = 1.0;
  double blur_share = 0.06;  ///< odometry drifts by 0.0075 m in a metre, 0.15 of a patch
  OccupancySettings occupancy;
  SalientSettings salient;
  LandmarkMemorySettings landmarks;
  LocalisationSettings localisation;
};

template <class V>
void visit(V& v, ShortTermMemorySettings& s) {
  using config::Unit;
  v.number("free_fades", s.free_fades_s, Unit::duration, {1, 600},
           "time constant: how long floor stays free unseen");
  v.number("occupied_fades", s.occupied_fades_s, Unit::duration, {1, 3600},
           "time constant of what stands still");
  v.number("moving_fades", s.moving_fades_s, Unit::duration, {0.2, 60},
           "time constant of what was seen to move");
  v.number("blur_after", s.blur_after_s, Unit::duration, {0.5, 600},
           "evidence older than this is blurred by the drift of the odometry");
  v.number("blur_every", s.blur_every_m, Unit::length, {0.1, 100}, "way between two blurs");
  v.number("blur_share", s.blur_share, Unit::fraction, {0, 0.5}, "what leaks to the neighbours");
  v.renamed("evidence", "occupancy");
  v.section("occupancy", s.occupancy);
  v.section("salient", s.salient);
  v.section("landmarks", s.landmarks);
  v.renamed("place", "localisation");
  v.section("localisation", s.localisation);
}

/// What the robot knows here and now: the evidence map, the corridor, seven salient regions, its
/// own state and what it was last told to do. Fixed memory: nothing is allocated after
/// construction. Behaviours, tasks and images read it; the cycle alone writes.
class ShortTermMemory {
 public:
  static constexpr std::size_t kCommands = 32;  ///< by hand: cycles, 3.2 s
  struct SentCommand {
    TimePoint stamp;
    MotorCommand command;
    FixedText<31> doing;
  };

  ShortTermMemory(const ShortTermMemorySettings& settings, const RobotDescription& robot);

  /// Once a cycle. The percept may be old, the same as before, or invalid; its evidence is placed
  /// where the robot was at the percept's stamp, and an image is used once.
  /// @param sightings landmarks that were recognised in the percept's image; each once
  /// @return this memory, as it is now
  const ShortTermMemory& update(const Senses& senses, const perception::Percept& percept,
                                std::span<const LandmarkSighting> sightings = {});
  /// What long-term memory knows of places. Once, before the first update; without it no place is
  /// estimated.
  void know_map(const MapKnowledge& knowledge) { place_.know(knowledge); }
  /// What is new about places, for who writes the long-term memory.
  [[nodiscard]] MapNews take_map_news(double operating_s) { return place_.take_news(operating_s); }
  /// The mission is over: what the map still holds goes with the next news.
  void close_map(bool failed);
  /// The efference copy: what really went to the motors, and which behaviour wanted it.
  /// @param held_by what the robot was stopped for without having seen it; robot frame
  void remember(const MotorCommand& sent, std::string_view doing,
                std::span<const Point2> held_by = {});
  /// A landmark was recognised in the image of `sighting.stamp`.
  void recognise(const LandmarkSighting& sighting);
  /// Long-term memory knows a landmark's place; in the odometry frame of this run.
  void recall(std::int64_t landmark, std::string_view name, const Point2& place, double sigma_m) {
    landmarks_.recall(landmark, name, place, sigma_m);
  }

  // The body.
  [[nodiscard]] const RobotDescription& robot() const { return robot_; }
  [[nodiscard]] TimePoint now() const { return now_; }
  [[nodiscard]] const Pose2& pose() const { return pose_; }  ///< odometry frame
  [[nodiscard]] Pose2 pose_at(TimePoint stamp) const { return history_.at(stamp); }
  [[nodiscard]] double forward_m_s() const { return forward_m_s_; }
  [[nodiscard]] double turn_rad_s() const { return turn_rad_s_; }
  [[nodiscard]] const HeadPose& head() const { return head_; }
  [[nodiscard]] double battery_v() const { return battery_v_; }
  [[nodiscard]] bool bumper() const { return bumper_; }
  [[nodiscard]] bool stalled() const { return stalled_; }
  /// Whether the robot was stopped by what it had not seen, no longer ago than this.
  [[nodiscard]] bool felt_within(Duration ago) const {
    return felt_.last() && now_ - *felt_.last() < ago;
  }
  [[nodiscard]] double distance_travelled_m() const { return travelled_m_; }
  /// Path along the corridor's axis since the start; back is negative.
  [[nodiscard]] double progress_m() const { return corridor_.progress_m(); }

  // What was seen.
  [[nodiscard]] const LocalGrid& map() const { return grid_; }
  [[nodiscard]] PolarMap polar_map() const { return read_polar_map(grid_, pose_, now_); }
  [[nodiscard]] const CorridorMemory& corridor() const { return corridor_; }
  [[nodiscard]] const SalientMemory& salient() const { return salient_; }
  [[nodiscard]] const LandmarkMemory& landmarks() const { return landmarks_; }
  /// Whether this sighting, once the next update takes it in, confirms its landmark; false where
  /// its image is too old to say where it belongs.
  [[nodiscard]] bool confirms(const LandmarkSighting& sighting) const {
    return history_.reaches(sighting.stamp) && landmarks_.confirms(sighting);
  }
  /// Where the robot has been, from the start on.
  [[nodiscard]] const Trajectory& trajectory() const { return trajectory_; }
  /// Where the robot is on the map of its memory, and the routes that were driven.
  [[nodiscard]] const Localisation& place() const { return place_; }
  [[nodiscard]] const RouteMap& routes() const { return place_.routes(); }
  /// Seconds since the newest image; infinity before the first.
  [[nodiscard]] double image_age_s() const;
  [[nodiscard]] double light_level() const { return light_level_; }  ///< 0..1
  [[nodiscard]] double noise_level() const { return noise_level_; }  ///< grey levels of 255
  /// Share of the newest image's columns that know anything, slowly averaged.
  [[nodiscard]] double seen_share() const { return seen_share_; }
  /// What a stage of a plugin found in the newest image: "STAGE.FIGURE", see perception/stage.hpp.
  /// @return NaN where it is not known, or there is no such figure
  [[nodiscard]] double figure(std::string_view name) const;

  // What was done. `steps_back` 0 is the newest; default command before the first.
  [[nodiscard]] const SentCommand& sent(std::size_t steps_back = 0) const;
  [[nodiscard]] std::string_view doing() const { return sent().doing.view(); }

 private:
  void feel(const Senses& senses);
  void see(const perception::Percept& percept);
  void fade();
  void fit_walls();
  void clear_own_place();
  [[nodiscard]] bool is_under_robot(Point2 place) const;

  ShortTermMemorySettings settings_;
  RobotDescription robot_;
  LocalGrid grid_;
  OccupancyUpdater occupancy_;
  BlankView blank_view_;
  FeltThings felt_;
  OdometryHistory history_;
  CorridorMemory corridor_;
  WallFitter wall_fitter_;
  SalientMemory salient_;
  LandmarkMemory landmarks_;
  Trajectory trajectory_;
  Localisation place_;
  std::vector<perception::SalientRegion> regions_now_;

  TimePoint now_{};
  Pose2 pose_;
  double forward_m_s_ = 0.0;
  double turn_rad_s_ = 0.0;
  HeadPose head_;
  double battery_v_ = 0.0;
  bool bumper_ = false;
  bool stalled_ = false;
  double travelled_m_ = 0.0;
  double blurred_at_m_ = 0.0;
  TimePoint faded_{};
  TimePoint fitted_{};

  bool image_seen_ = false;
  TimePoint image_stamp_{};
  double light_level_ = 0.0;
  double noise_level_ = 0.0;
  double seen_share_ = 0.0;

  std::array<SentCommand, kCommands> sent_{};
  std::size_t next_sent_ = 0;

  std::vector<perception::Figure> figures_;  ///< of the newest image
};

}  // namespace striate::memory
