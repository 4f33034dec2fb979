#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "striate/platform/datasets/sequences/picture_list.hpp"
#include "striate/platform/datasets/sequences/sequence.hpp"

/// What open_sequence() is made of: pictures or videos, with the calibration that was found.
namespace striate::datasets {

struct FoundCalibration {
  std::optional<StereoModel> model;
  std::string file;
};

/// The calibration that is given, that of the set's layout, or what lies in the folder and can only
/// be one. @param list takes remarks
[[nodiscard]] FoundCalibration calibration_of(const std::filesystem::path& folder,
                                              PictureList& list, const SequenceOptions& options);
[[nodiscard]] FoundCalibration read_found(const std::vector<std::filesystem::path>& files,
                                          const SequenceOptions& options);

[[nodiscard]] std::unique_ptr<Sequence> open_pictures(PictureList list, FoundCalibration found,
                                                      const SequenceOptions& options);
/// @param files one video, or the left eye's and the right one's
[[nodiscard]] std::unique_ptr<Sequence> open_videos(const std::vector<std::filesystem::path>& files,
                                                    FoundCalibration found,
                                                    const SequenceOptions& options);

}  // namespace striate::datasets
