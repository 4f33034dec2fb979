#include "striate/perception/recognition/claims.hpp"

#include <algorithm>
#include <cmath>

namespace striate::perception {

void Claims::put(std::size_t number, std::span<const PlacePair> agreeing) {
  in_use_ = std::max(in_use_, number + 1);
  if (of_.size() < in_use_) of_.resize(in_use_);
  of_[number].assign(agreeing.begin(), agreeing.end());
}

/// The same place at a neighbouring scale is the same thing's: within half of the larger size.
bool Claims::is_taken(const KeypointFrame& place) const {
  return std::ranges::any_of(taken_, [&](const KeypointFrame& other) {
    const double reach_px = 0.5 * std::max(place.size_px, other.size_px);
    return std::hypot(place.u_px - other.u_px, place.v_px - other.v_px) < reach_px;
  });
}

std::span<const PlacePair> Claims::left(std::size_t number) {
  left_.clear();
  for (const PlacePair& pair : of_[number]) {
    if (!is_taken(pair.image)) left_.push_back(pair);
  }
  return left_;
}

void Claims::take(std::size_t number) {
  for (const PlacePair& pair : of_[number]) taken_.push_back(pair.image);
}

}  // namespace striate::perception
