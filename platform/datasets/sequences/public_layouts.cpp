#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "striate/base/files.hpp"
#include "striate/base/user_error.hpp"
#include "striate/platform/datasets/calibration/text_tree.hpp"
#include "striate/platform/datasets/sequences/picture_list.hpp"

namespace striate::datasets {
namespace {

namespace fs = std::filesystem;

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

std::vector<std::string> lines_in(const fs::path& file) {
  const std::string text = plain_line_ends(read_file(file.string()));
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    lines.push_back(trimmed(text.substr(at, end - at)));
    at = end + 1;
  }
  return lines;
}

/// One camera of an ASL folder: its data.csv, or where there is none the pictures' names.
std::vector<PictureEntry> asl_camera(const fs::path& camera, PictureList& list) {
  const fs::path folder = folder_of_pictures(camera);
  std::error_code error;
  if (!fs::exists(camera / "data.csv", error)) {
    list.remarks.push_back(fmt::format("{} is missing: times are taken from the pictures' names",
                                       (camera / "data.csv").string()));
    return entries_of(pictures_in(folder));
  }
  std::vector<PictureEntry> entries;
  int number = 0;
  for (const std::string& line : lines_in(camera / "data.csv")) {
    ++number;
    if (line.empty() || line.starts_with("#")) continue;
    const std::size_t comma = line.find_first_of(",; \t");
    const std::string stamp = trimmed(line.substr(0, comma));
    std::string name = comma == std::string::npos ? "" : trimmed(line.substr(comma + 1));
    if (name.empty()) name = stamp + ".png";
    const auto stamp_ns = stamp_in_name(stamp);
    if (!stamp_ns) {
      if (number == 1) continue;  // a head without its #
      throw UserError(
          fmt::format("{}:{}:1: '{}' is no time in ns\n    hint: lines are "
                      "\"timestamp,file\", as EuRoC has them",
                      (camera / "data.csv").string(), number, stamp.substr(0, 40)));
    }
    entries.push_back({fs::path(name).stem().string(),
                       (folder.empty() ? camera / "data" : folder) / fs::path(name).filename(),
                       {},
                       stamp_ns});
  }
  return entries;
}

bool is_asl_camera(const fs::path& folder) {
  std::error_code error;
  return fs::exists(folder / "data.csv", error) || fs::is_directory(folder / "data", error);
}

/// Seconds since the beginning, one line a picture.
void add_times(const fs::path& file, PictureList& list) {
  std::error_code error;
  if (!fs::exists(file, error)) return;
  std::vector<std::int64_t> times_ns;
  for (const std::string& line : lines_in(file)) {
    if (line.empty() || line.starts_with("#")) continue;
    const auto time_s = number_of(line);
    if (!time_s || std::abs(*time_s) > 9e9) {
      list.remarks.push_back(fmt::format("{}: '{}' is no time in seconds: not used", file.string(),
                                         line.substr(0, 40)));
      return;
    }
    times_ns.push_back(std::llround(1e9 * *time_s));
  }
  if (times_ns.size() < list.entries.size()) {
    list.remarks.push_back(fmt::format("{} has {} times for {} pictures: not used", file.string(),
                                       times_ns.size(), list.entries.size()));
    return;
  }
  if (times_ns.size() > list.entries.size()) {
    list.remarks.push_back(fmt::format("{} has {} times for {} pictures: the first are taken",
                                       file.string(), times_ns.size(), list.entries.size()));
  }
  // Where names are numbers they say which line is theirs, should pictures be missing.
  for (std::size_t k = 0; k < list.entries.size(); ++k) {
    const auto number = number_of(list.entries[k].name);
    const auto line = number && *number >= 0.0 && *number < static_cast<double>(times_ns.size())
                          ? static_cast<std::size_t>(*number)
                          : k;
    list.entries[k].stamp_ns = times_ns[line];
  }
}

}  // namespace

std::optional<PictureList> find_euroc(const fs::path& given) {
  std::error_code error;
  const fs::path folder = fs::is_directory(given / "mav0", error) ? given / "mav0" : given;
  if (!is_asl_camera(folder / "cam0")) return {};
  PictureList list;
  list.kind = "EuRoC (ASL)";
  const std::vector<PictureEntry> left = asl_camera(folder / "cam0", list);
  for (const char* camera : {"cam0", "cam1"}) {
    const fs::path sensor = folder / camera / "sensor.yaml";
    if (fs::exists(sensor, error)) list.calibration.push_back(sensor);
  }
  if (!is_asl_camera(folder / "cam1")) {
    list.remarks.emplace_back("there is no cam1: one eye");
    list.entries = left;
  } else {
    pair_eyes(left, asl_camera(folder / "cam1", list), list);
  }
  judge_stamps(list);
  return list;
}

std::optional<PictureList> find_kitti(const fs::path& folder) {
  std::error_code error;
  constexpr std::pair<const char*, int> kCameras[] = {
      {"image_0", 0}, {"image_2", 2}, {"image_00", 0}, {"image_02", 2}};
  for (const auto& [name, first] : kCameras) {
    const fs::path pictures = folder_of_pictures(folder / name);
    if (pictures.empty()) continue;
    std::string other = name;
    other.back() = static_cast<char>(other.back() + 1);
    PictureList list;
    list.kind = fmt::format("KITTI ({}, {})", name, other);
    list.kitti_first = first;
    const std::vector<PictureEntry> left = entries_of(pictures_in(pictures));
    const fs::path right = folder_of_pictures(folder / other);
    if (right.empty()) {
      list.entries = left;
      list.remarks.push_back(fmt::format("there is no {}: one eye", other));
    } else {
      pair_eyes(left, entries_of(pictures_in(right)), list);
    }
    add_times(folder / "times.txt", list);
    for (const char* file : {"calib.txt", "calib_cam_to_cam.txt", "../calib_cam_to_cam.txt"}) {
      if (!fs::exists(folder / file, error)) continue;
      list.calibration.push_back(folder / file);
      break;
    }
    judge_stamps(list);
    return list;
  }
  return {};
}

std::optional<PictureList> find_single(const fs::path& given) {
  const fs::path folder = folder_of_pictures(given);
  if (folder.empty()) return {};
  PictureList list;
  list.kind = "pictures of one eye";
  list.entries = entries_of(pictures_in(folder));
  for (const char* file : {"times.txt", "timestamps.txt"}) add_times(given / file, list);
  judge_stamps(list);
  return list;
}

}  // namespace striate::datasets
