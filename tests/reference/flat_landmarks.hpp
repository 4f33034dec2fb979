#pragma once

#include <string>
#include <vector>

#include "tests/reference/flat_run.hpp"

/// Landmarks of the flat world, and what recognition would say of them: in view, near enough, with
/// errors of bearing and distance, and not in every image.
namespace striate::flat {

struct Landmark {
  std::string name;
  Point2 at;
};

struct RecogniserErrors {
  double reach_m = 2.6;
  double half_view_rad = 0.33;
  double distance_share = 0.05;
  double bearing_rad = 0.01;
  double missed = 0.4;
};

class Recogniser {
 public:
  Recogniser(std::vector<Landmark> landmarks, std::uint64_t seed,
             const RecogniserErrors& errors = {})
      : landmarks_(std::move(landmarks)), errors_(errors), random_(seed ^ 0x777ULL) {}

  void operator()(Loop& loop) {
    for (std::size_t i = 0; i < landmarks_.size(); ++i) {
      const Point2 seen = inverse_transform(loop.world.pose(), landmarks_[i].at);
      const double distance_m = std::hypot(seen.x_m, seen.y_m);
      const double bearing_rad = std::atan2(seen.y_m, seen.x_m);
      const double off_rad = wrap_angle(bearing_rad - loop.world.head().pan_rad);
      const bool missed = random_.chance(errors_.missed);
      const double error_m = errors_.distance_share * distance_m * random_.normal();
      const double error_rad = errors_.bearing_rad * random_.normal();
      if (missed || distance_m > errors_.reach_m || std::abs(off_rad) > errors_.half_view_rad) {
        continue;
      }
      loop.memory.recognise({static_cast<std::int64_t>(i + 1), landmarks_[i].name, loop.senses.now,
                             0.8, bearing_rad + error_rad, distance_m + error_m});
    }
  }

 private:
  std::vector<Landmark> landmarks_;
  RecogniserErrors errors_;
  Random random_;
};

}  // namespace striate::flat
