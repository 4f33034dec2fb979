#include "striate/perception/recognition/shared_parts.hpp"

#include "striate/perception/recognition/view_parts.hpp"

namespace striate::perception {

std::size_t SharedParts::part_of(const KeypointFrame& place) const {
  return part_of_view(place, width_px_, height_px_, kAcross);
}

void SharedParts::begin(std::span<const KeypointFrame> places, double width_px, double height_px) {
  clear();
  width_px_ = width_px;
  height_px_ = height_px;
  for (const KeypointFrame& place : places) ++keypoints_[part_of(place)];
}

void SharedParts::add(std::span<const PlacePair> agreeing) {
  // Half of a label's keypoints agree at most, a chance one in a part is no label (by hand).
  constexpr int kLeast = 2;
  constexpr double kLeastShare = 0.15;
  std::array<int, kParts> agree{};
  for (const PlacePair& pair : agreeing) ++agree[part_of(pair.image)];
  for (std::size_t k = 0; k < kParts; ++k) {
    if (agree[k] >= kLeast && agree[k] >= kLeastShare * keypoints_[k]) shared_[k] = true;
  }
}

void SharedParts::finish() {
  // Of a view's keypoints, and of its parts with keypoints: less is what comparing has missed of a
  // thing that was taught under two names (by hand).
  constexpr double kLeastOwn = 0.2;
  constexpr double kLeastOwnParts = 0.3;
  constexpr int kFewest = 8;  // keypoints: too few to be recognised by (by hand)
  int all = 0, own = 0, parts = 0, own_parts = 0;
  for (std::size_t k = 0; k < kParts; ++k) {
    any_ = any_ || shared_[k];
    all += keypoints_[k];
    parts += keypoints_[k] > 0 ? 1 : 0;
    if (shared_[k]) continue;
    own += keypoints_[k];
    own_parts += keypoints_[k] > 0 ? 1 : 0;
  }
  const bool alike = own < kLeastOwn * all && own_parts < kLeastOwnParts * parts;
  if (alike || own < kFewest) {
    shared_ = {};
    any_ = false;
  }
  known_ = true;
}

}  // namespace striate::perception
