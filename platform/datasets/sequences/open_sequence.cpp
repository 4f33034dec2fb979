#include <fmt/format.h>

#include <algorithm>

#include "striate/base/user_error.hpp"
#include "striate/platform/datasets/sequences/opened_sequences.hpp"

namespace striate::datasets {

void Sequence::leave_out(const std::string& why) {
  constexpr std::size_t kTold = 5;  // lines: a person reads no more of one kind (ours)
  if (++left_out_count_ <= kTold) left_out_.push_back(why);
}

namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse_folder(const fs::path& folder) {
  std::string there;
  std::size_t count = 0;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    if (++count > 6) continue;
    there += (there.empty() ? "" : ", ") + entry.path().filename().string() +
             (entry.is_directory(error) ? "/" : "");
  }
  throw UserError(fmt::format(
      "{}: holds no pictures that can be put in order{}\n    hint: a folder left/ and right/ (or "
      "cam0/, cam1/), pairs such as 001_left.png and 001_right.png, EuRoC's mav0, KITTI's image_0 "
      "and image_1, a folder of pictures, or a video",
      folder.string(),
      there.empty() ? "; it is empty"
                    : fmt::format("; in it are {}{}", there, count > 6 ? ", ..." : "")));
}

std::optional<PictureList> list_of(const fs::path& folder, bool side_by_side) {
  if (side_by_side) return find_single(folder);
  for (const auto find : {find_euroc, find_kitti, find_folder_pairs, find_name_pairs}) {
    if (auto list = find(folder)) return list;
  }
  return {};
}

/// left.mp4 and right.mp4; or the only video that is there.
std::vector<fs::path> videos_in(const fs::path& folder) {
  std::vector<fs::path> videos;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    if (is_video(entry.path())) videos.push_back(entry.path());
  }
  std::ranges::sort(videos);
  for (const fs::path& left : videos) {
    for (const RightName& other : right_names(left.stem().string())) {
      const fs::path right = folder / (other.name + left.extension().string());
      if (std::ranges::find(videos, right) != videos.end()) return {left, right};
    }
  }
  return videos.size() == 1 ? videos : std::vector<fs::path>{};
}

std::unique_ptr<Sequence> open_folder(const fs::path& folder, const SequenceOptions& options) {
  std::optional<PictureList> list = list_of(folder, options.side_by_side);
  if (!list) {
    if (const std::vector<fs::path> videos = videos_in(folder); !videos.empty()) {
      PictureList none;
      FoundCalibration found = calibration_of(folder, none, options);
      return open_videos(videos, std::move(found), options);
    }
    list = find_single(folder);
  }
  if (!list || list->entries.empty()) refuse_folder(folder);
  FoundCalibration found = calibration_of(folder, *list, options);
  return open_pictures(std::move(*list), std::move(found), options);
}

}  // namespace

std::unique_ptr<Sequence> open_sequence(const fs::path& path, const SequenceOptions& options) {
  if (options.every < 1) throw UserError("--every must be 1 or more");
  std::error_code error;
  if (!fs::exists(path, error)) {
    throw UserError(fmt::format("{}: there is no such file or folder", path.string()));
  }
  if (fs::is_directory(path, error)) return open_folder(path, options);
  PictureList list;
  FoundCalibration found;
  if (!options.calibration.empty()) found = read_found(options.calibration, options);
  if (is_video(path)) {
    return open_videos({path}, std::move(found), options);
  }
  list.kind = "one picture";
  list.entries.push_back({path.stem().string(), path, {}, {}});
  return open_pictures(std::move(list), std::move(found), options);
}

}  // namespace striate::datasets
