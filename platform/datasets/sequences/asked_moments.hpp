#pragma once

#include <optional>

#include "striate/platform/datasets/sequences/sequence.hpp"

namespace striate::datasets {

/// Which moments are asked for.
class AskedMoments {
 public:
  explicit AskedMoments(const SequenceOptions& options) : options_(options) {}
  /// @param since_s time since the beginning; nothing: not known
  [[nodiscard]] bool takes(std::size_t number, std::optional<double> since_s) const {
    if (number % static_cast<std::size_t>(options_.every) != 0) return false;
    return !before(options_.from, number, since_s) && !is_behind(number, since_s);
  }
  [[nodiscard]] bool is_behind(std::size_t number, std::optional<double> since_s) const {
    if (!options_.to) return false;
    return options_.to->seconds ? since_s && *since_s > options_.to->value
                                : static_cast<double>(number) > options_.to->value;
  }
  [[nodiscard]] bool needs_times() const {
    return (options_.from && options_.from->seconds) || (options_.to && options_.to->seconds);
  }

 private:
  static bool before(const std::optional<SequencePlace>& place, std::size_t number,
                     std::optional<double> since_s) {
    if (!place) return false;
    return place->seconds ? since_s && *since_s < place->value
                          : static_cast<double>(number) < place->value;
  }
  SequenceOptions options_;
};

/// Whether each picture holds both eyes, as a calibration of half the width tells.
[[nodiscard]] inline bool holds_both(const std::optional<StereoModel>& calibration,
                                     cv::Size picture) {
  if (!calibration || calibration->left.size_px.empty()) return false;
  const cv::Size told = calibration->left.size_px;
  return picture.width == 2 * told.width && picture.height == told.height;
}

}  // namespace striate::datasets
