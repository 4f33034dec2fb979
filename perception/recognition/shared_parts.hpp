#pragma once

#include <array>
#include <span>

#include "striate/perception/recognition/pose.hpp"

namespace striate::perception {

/// Which parts of a view, cut into 8 x 8, other landmarks have, too: a brand's label, a bar code,
/// the print that all sides of a series share. They tell of the brand, not of the thing.
class SharedParts {
 public:
  void clear() { *this = {}; }
  /// @param places of the view's keypoints
  void begin(std::span<const KeypointFrame> places, double width_px, double height_px);
  /// Another landmark's view that agrees with this one.
  /// @param agreeing with this view's keypoints as `image`
  void add(std::span<const PlacePair> agreeing);
  /// Where nearly all of it is shared, nothing tells the two apart, and nothing counts as shared.
  void finish();

  [[nodiscard]] bool known() const { return known_; }
  [[nodiscard]] bool any() const { return any_; }
  [[nodiscard]] bool holds(const KeypointFrame& place) const { return shared_[part_of(place)]; }

 private:
  static constexpr int kAcross = 8;
  static constexpr std::size_t kParts = std::size_t{kAcross} * kAcross;
  [[nodiscard]] std::size_t part_of(const KeypointFrame& place) const;

  bool known_ = false;
  bool any_ = false;
  double width_px_ = 1.0, height_px_ = 1.0;
  std::array<int, kParts> keypoints_{};
  std::array<bool, kParts> shared_{};
};

}  // namespace striate::perception
