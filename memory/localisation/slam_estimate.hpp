#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "striate/memory/localisation/ekf_slam.hpp"
#include "striate/memory/localisation/localisation_settings.hpp"
#include "striate/memory/short_term/landmark_memory.hpp"

namespace striate::memory {

/// What became of a sighting.
enum class SightingVerdict {
  taken,      ///< corrected the pose and the landmark's place
  placed,     ///< the landmark has a place now
  too_alike,  ///< the robot has hardly moved since the last look: no new witness
  rejected,   ///< too far from where it is expected: another thing, or it was moved
  no_range,   ///< a place cannot be had from it
  no_room,
};

/// What is known about the place of one landmark.
struct MappedLandmark {
  std::int64_t landmark = 0;
  std::optional<MapPosition>
      known;                 ///< map frame, from earlier missions; independent of the filter
  int number = -1;           ///< in the filter; -1: not seen in this run
  int taken = 0;             ///< looks
  int rejected = 0;          ///< looks in a row
  double looked_at_m = 0.0;  ///< way at the last look
  double looked_at_rad = 0.0;
  double seen_at_m = -1e9;  ///< way at the last look that was taken
  bool news = false;        ///< its place has changed since it was told last
};

/// Joint estimation of the robot's pose and the landmarks' places. While it is not known where on
/// the map of earlier missions this run started, it runs in a frame of its own that begins at the
/// start; the first landmark that lies where a start at home lets expect it, or else two known
/// landmarks that lie to each other as they should, tie the two frames together. A robot that
/// stands adds nothing, and a sighting outside the gate changes nothing.
class SlamEstimate {
 public:
  explicit SlamEstimate(const LocalisationSettings& settings)
      : settings_(settings), filter_(settings) {}

  /// Once, at the start of a run: allocates.
  void start(const Pose2& odometry);
  /// Before the first sighting. @param place map frame
  void know(std::int64_t landmark, const std::optional<MapPosition>& place);
  void move(const Pose2& odometry);
  SightingVerdict see(const LandmarkSighting& sighting, const Pose2& at);

  /// Whether the estimates are in the map's frame.
  [[nodiscard]] bool located() const { return located_; }
  /// In the map's frame, or the run's own while not located; so are the landmarks' places.
  [[nodiscard]] Pose2 pose() const { return filter_.pose(); }
  [[nodiscard]] PoseCovariance pose_covariance() const { return filter_.pose_covariance(); }
  /// Puts points of the odometry frame into the frame of the estimates.
  [[nodiscard]] Pose2 from_odometry() const;
  [[nodiscard]] const Pose2& odometry() const { return odometry_; }
  [[nodiscard]] double way_m() const { return way_m_; }
  /// Where this run started, as it is known by now, frame of the estimates.
  [[nodiscard]] Pose2 start() const;

  [[nodiscard]] std::span<const MappedLandmark> landmarks() const { return landmarks_; }
  /// Where it is, frame of the estimates, with its covariance; nothing where that is not known.
  [[nodiscard]] std::optional<MapPosition> place(const MappedLandmark& landmark) const;
  [[nodiscard]] std::optional<MapPosition> place(std::int64_t landmark) const;
  /// The same with the covariance relative to the robot; also where a landmark is supposed to be as
  /// long as nothing contradicts a start at home.
  [[nodiscard]] std::optional<MapPosition> place_from_robot(const MappedLandmark& landmark) const;
  /// Places of the map frame that are surer now than they were told last.
  template <class Sink>
  void tell_news(Sink sink) {
    if (!located_) return;
    for (MappedLandmark& one : landmarks_) {
      if (!one.news || one.number < 0 || one.taken < kSure) continue;
      one.news = false;
      sink(one.landmark, filter_.place(one.number));
    }
  }

 private:
  static constexpr int kSure = 2;  ///< by hand: looks that make a place worth keeping

  MappedLandmark* entry_for(std::int64_t landmark);
  SightingVerdict take(MappedLandmark& one, const LandmarkSighting& sighting, const Pose2& from);
  SightingVerdict reject(MappedLandmark& one, const std::optional<EkfSlam::Seen>& seen);
  SightingVerdict put(MappedLandmark& one, const EkfSlam::Seen& seen);
  [[nodiscard]] EkfSlam::Seen seen_from(const LandmarkSighting& sighting, const Pose2& from) const;
  bool make_room();
  void drop(MappedLandmark& one);
  void try_to_locate(const MappedLandmark& newest);
  [[nodiscard]] bool may_have_started_at_home() const;
  [[nodiscard]] MapPosition from_home(const MapPosition& known) const;
  [[nodiscard]] std::optional<Pose2> frame_by(const MappedLandmark& a,
                                              const MappedLandmark& b) const;
  void locate(const Pose2& frame, double sigma_m, double sigma_rad);

  LocalisationSettings settings_;
  EkfSlam filter_;
  std::vector<MappedLandmark> landmarks_;
  bool map_is_known_ = false;
  bool located_ = false;
  int contradictions_ = 0;  ///< of landmarks to a start at home
  Pose2 odometry_;
  double start_heading_rad_ = 0.0;
  double way_m_ = 0.0;
  double turned_rad_ = 0.0;
};

}  // namespace striate::memory
