#include "striate/memory/short_term/trajectory.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace striate::memory {
void Trajectory::walk(const Pose2& here) {
  const Point2 place{here.x_m, here.y_m};
  if (count_ == 0) start_ = here;
  if (count_ > 0 && apart_m(place, crumbs_[count_ - 1]) < step_m_) return;
  if (count_ == kCapacity) thin();
  crumbs_[count_++] = place;
}

void Trajectory::thin() {
  for (std::size_t i = 0; 2 * i < count_; ++i) crumbs_[i] = crumbs_[2 * i];
  count_ = (count_ + 1) / 2;
  step_m_ *= 2.0;
}

std::size_t Trajectory::nearest(Point2 place) const {
  std::size_t best = 0;
  for (std::size_t i = 1; i < count_; ++i) {
    if (apart_m(place, crumbs_[i]) < apart_m(place, crumbs_[best])) best = i;
  }
  return best;
}

double Trajectory::distance_m(Point2 place, std::size_t skipped) const {
  double least_m = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + skipped < count_; ++i) {
    least_m = std::min(least_m, apart_m(place, crumbs_[i]));
  }
  return least_m;
}

}  // namespace striate::memory
