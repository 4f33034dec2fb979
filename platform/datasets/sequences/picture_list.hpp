#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "striate/platform/datasets/calibration/camera_model.hpp"

namespace striate::datasets {

/// The files of one moment.
struct PictureEntry {
  std::string name;
  std::filesystem::path left;
  std::filesystem::path right;  ///< empty: one eye, or both in `left`
  std::optional<std::int64_t> stamp_ns;
};

/// What a folder holds, in the order in which it was taken.
struct PictureList {
  std::string kind;
  std::vector<PictureEntry> entries;
  std::vector<std::filesystem::path> calibration;  ///< files of the set's own layout; may be empty
  int kitti_first = 0;                             ///< of a KITTI calibration: the left camera
  std::vector<std::string> remarks;
};

/// Frame 2 before frame 10.
[[nodiscard]] bool natural_less(const std::string& a, const std::string& b);

/// A name that is a time: 19 digits are ns, 16 are us, "1305031102.175304" are seconds.
[[nodiscard]] std::optional<std::int64_t> stamp_in_name(const std::string& stem);

/// The pictures right in this folder, in natural order; files that begin with a dot are none.
[[nodiscard]] std::vector<std::filesystem::path> pictures_in(const std::filesystem::path& folder);

/// One eye's, with the times that their names tell.
[[nodiscard]] std::vector<PictureEntry> entries_of(
    const std::vector<std::filesystem::path>& pictures);

/// The folder itself, or the one folder below it (data/ before others) that holds pictures; empty:
/// there is none.
[[nodiscard]] std::filesystem::path folder_of_pictures(const std::filesystem::path& folder);

/// Puts the pictures of both eyes together: by name, and where names are times that differ, by the
/// nearest within half of the usual step. What has no partner, how far the eyes are out of step and
/// where pictures are missing goes into the remarks.
void pair_eyes(const std::vector<PictureEntry>& left, const std::vector<PictureEntry>& right,
               PictureList& list);

/// Adds a remark where the stamps leap, stand still or go back; sorts them by time first.
void judge_stamps(PictureList& list);

/// Nothing where the folder has not this layout.
[[nodiscard]] std::optional<PictureList> find_euroc(const std::filesystem::path& folder);
[[nodiscard]] std::optional<PictureList> find_kitti(const std::filesystem::path& folder);
/// Folders named for the eyes, or names that tell the eye.
[[nodiscard]] std::optional<PictureList> find_folder_pairs(const std::filesystem::path& folder);
[[nodiscard]] std::optional<PictureList> find_name_pairs(const std::filesystem::path& folder);
[[nodiscard]] std::optional<PictureList> find_single(const std::filesystem::path& folder);

/// By the suffix: a video that OpenCV may open.
[[nodiscard]] bool is_video(const std::filesystem::path& file);

/// What a left eye's name becomes for the right eye's, under one rule.
struct RightName {
  int rule = 0;  ///< 0 is the plainest (left, right); higher ones are vaguer
  std::string name;
};
inline constexpr int kNameRules = 10;  // numbered in eye_names.cpp

/// Under each rule that fits; for folders and for stems of pictures and videos.
[[nodiscard]] std::vector<RightName> right_names(const std::string& left);

}  // namespace striate::datasets
