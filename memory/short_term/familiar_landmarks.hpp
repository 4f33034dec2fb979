#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "striate/memory/long_term/activation.hpp"
#include "striate/memory/long_term/learning.hpp"
#include "striate/memory/long_term/long_term_settings.hpp"
#include "striate/memory/short_term/short_term_memory.hpp"
#include "striate/perception/recognition/landmark_finder.hpp"

namespace striate::memory {

/// A landmark with the views by which it is recognised.
struct LandmarkModel {
  Landmark record;
  std::vector<perception::LandmarkView> views;
};

/// What long-term memory knows when a mission starts; read once, from then on held in RAM.
struct LandmarkKnowledge {
  std::vector<LandmarkModel> landmarks;
  std::vector<Route> routes;
  double operating_start_s = 0.0;  ///< operating time when the mission starts
};

/// What a look has taught about a landmark; to be kept by who writes the long-term memory.
struct LandmarkLesson {
  enum class Kind { recognised, missed };
  Kind kind = Kind::recognised;
  std::int64_t landmark = 0;
  std::string_view name;     ///< valid as long as the FamiliarLandmarks
  double bearing_rad = 0.0;  ///< recognised: robot frame; missed: 0
  double distance_m = 0.0;   ///< recognised: kNothing_m where unknown; missed: 0
};

/// What recognition in one image comes to, by name.
struct Recognised {
  std::vector<LandmarkSighting> sightings;  ///< for short-term memory to take in
  std::vector<LandmarkLesson> lessons;      ///< for long-term memory to keep
};

/// The landmarks of long-term memory at work: says in which order and where they are looked for,
/// names what was recognised, and decides what a look teaches. Touches no disk.
class FamiliarLandmarks {
 public:
  /// Knows nothing and costs nothing.
  FamiliarLandmarks() = default;
  /// @param sought the landmark that the task is after: it comes to mind first. "" or an unknown
  /// one: none.
  FamiliarLandmarks(const LandmarkKnowledge& knowledge, const LongTermSettings& settings,
                    std::string_view sought = {});

  /// How the next image is to be looked at: views by activation, and where landmarks are
  /// expected. Valid until the next call.
  /// @param at the robot when the image was taken, odometry frame
  [[nodiscard]] perception::LandmarkExpectations expectations(const ShortTermMemory& memory,
                                                              const Pose2& at);

  /// What was recognised in a new image, and what that teaches: a sighting that is confirmed and
  /// new makes a landmark stronger, one missed again and again makes it weaker. Valid until the
  /// next call.
  /// @param memory as it is before it takes the sightings in
  [[nodiscard]] const Recognised& recognised(const perception::Percept& percept,
                                             const Senses& senses, const ShortTermMemory& memory);

  [[nodiscard]] std::size_t size() const { return known_.size(); }

 private:
  struct KnownLandmark {
    Landmark record;
    std::vector<int> views;  ///< their numbers
    double activation = 0.0;
    std::optional<double> height_m;  ///< of its middle, when it was seen last in this run
  };

  void order_by_activation(const ShortTermMemory& memory);
  void strengthen(KnownLandmark& known, const perception::Recognition& found, const Senses& senses);
  void weaken(KnownLandmark& known, const Point2& here);

  LongTermSettings settings_;
  std::vector<KnownLandmark> known_;
  std::vector<Route> routes_;
  double operating_start_s_ = 0.0;
  std::int64_t goal_ = 0;
  std::optional<Learning> learning_;
  std::optional<TimePoint> ordered_;
  Situation situation_;
  std::vector<std::size_t> by_activation_;
  std::vector<int> order_;
  std::vector<perception::LandmarkExpectation> expected_;
  Recognised recognised_;
};

/// All views of what is known, in the order in which FamiliarLandmarks numbers them: what
/// perception is built with.
[[nodiscard]] std::vector<perception::KnownView> views_of(const LandmarkKnowledge& knowledge);

}  // namespace striate::memory
