#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "striate/platform/datasets/trajectories/trajectory.hpp"

namespace striate::evaluation {

/// One image of a sequence, as its truth is looked up.
struct PlacedImage {
  std::string name;    ///< of the file, or "frame 17"
  std::size_t number;  ///< in the sequence, from 0
  std::optional<std::int64_t> stamp_ns;
};

struct PlaceTruthSettings {
  double within_m = 2.0;     ///< two images of one place are no farther apart ...
  double within_deg = 40.0;  ///< ... and no more turned: about the eyes' field of view
  double within_places = 2;  ///< labels of one place differ by no more
};

/// Which images of a sequence are of one place.
class PlaceTruth {
 public:
  /// Whether anything is known of where the image was taken.
  [[nodiscard]] bool tells_of(std::size_t image) const { return told_[image]; }
  /// False, too, where one of them is of no place that is seen twice.
  [[nodiscard]] bool same(std::size_t a, std::size_t b) const;

  /// By position and direction, interpolated at the images' times (their numbers where neither has
  /// times).
  /// @throws UserError where fewer than three images have a pose, saying why
  [[nodiscard]] static PlaceTruth of_trajectory(const datasets::Trajectory& trajectory,
                                                const std::vector<PlacedImage>& images,
                                                const PlaceTruthSettings& settings);
  /// By labels that a person gave.
  /// @throws UserError naming the line of what is wrong
  [[nodiscard]] static PlaceTruth of_labels(const std::filesystem::path& file,
                                            const std::vector<PlacedImage>& images,
                                            const PlaceTruthSettings& settings);

 private:
  PlaceTruth(std::size_t images, double within, double within_rad)
      : told_(images), poses_(images), within_(within), within_rad_(within_rad) {}

  std::vector<char> told_;
  /// Of labels, the label stands for the way.
  std::vector<std::optional<datasets::TimedPose>> poses_;
  double within_, within_rad_;
};

/// Is it a file of labels, a line "image,place" and then one for each image: its file's name and a
/// number that grows along the way; without a number it is of a place that is seen but once?
[[nodiscard]] bool is_place_labels(const std::filesystem::path& file);

}  // namespace striate::evaluation
