#include "striate/memory/long_term/view_comparer.hpp"

#include <algorithm>

#include "striate/memory/long_term/view_codec.hpp"

namespace striate::memory {
namespace {

perception::KeypointFrame place_of(const perception::ViewKeypoint& point) {
  return {point.x_px, point.y_px, std::max(0.01F, point.size_px), point.angle_rad};
}

}  // namespace

Agreement ViewComparer::compare(const StoredView& a, const StoredView& b) {
  if (a.damaged || b.damaged || a.keypoints.empty() || b.keypoints.empty()) return {};
  store_.clear();
  for (const StoredDescriptor& one : b.descriptors) store_.append(descriptor_of(one));
  queries_.clear();
  for (const StoredDescriptor& one : a.descriptors) queries_.push_back(descriptor_of(one));
  const auto limit = static_cast<std::uint32_t>(settings_.limit_bits);
  pairs_.clear();
  for (std::size_t k = 0;
       const perception::NearestTwo& near : search_.nearest_two(queries_, store_)) {
    const std::size_t at = k++;
    if (near.first == perception::NearestTwo::kNone || near.first_bits >= limit) continue;
    if (near.first_bits > settings_.ratio * near.second_bits) continue;
    pairs_.push_back({place_of(b.keypoints[near.first]), place_of(a.keypoints[at]),
                      static_cast<int>(near.first)});
  }
  const perception::Consensus found = consensus_.find(pairs_, b.width_px, b.height_px);
  const std::size_t fewer = std::min(a.keypoints.size(), b.keypoints.size());
  return {found.inliers, static_cast<double>(found.inliers) / static_cast<double>(fewer)};
}

}  // namespace striate::memory
