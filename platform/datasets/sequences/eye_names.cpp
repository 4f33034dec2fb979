#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <set>

#include "striate/base/lower_case.hpp"
#include "striate/platform/datasets/sequences/picture_list.hpp"

namespace striate::datasets {
namespace {

namespace fs = std::filesystem;

bool is_letter(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0;
}

bool is_number(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

/// `left` in any case, wherever it stands.
void add_left_right(const std::string& name, std::vector<RightName>& found) {
  const std::string small = lower_case(name);
  const std::size_t at = small.find("left");
  if (at == std::string::npos) return;
  const bool upper = name[at] == 'L';
  const bool all_upper = upper && name[at + 1] == 'E';
  const char* const right = all_upper ? "RIGHT" : upper ? "Right" : "right";
  found.push_back({0, name.substr(0, at) + right + name.substr(at + 4)});
}

/// One letter that stands for an eye, at an end of the name and apart from other letters.
void add_letters(const std::string& name, std::vector<RightName>& found) {
  const auto apart = [&](std::size_t k) {
    if (k >= name.size()) return true;
    // imL: a capital behind small letters stands apart, too
    return !is_letter(name[k]) || std::islower(static_cast<unsigned char>(name[k])) != 0;
  };
  const char last = name.back();
  if (last == 'L' && apart(name.size() - 2))
    found.push_back({2, name.substr(0, name.size() - 1) + "R"});
  if (last == 'l' && (name.size() < 2 || !is_letter(name[name.size() - 2]))) {
    found.push_back({2, name.substr(0, name.size() - 1) + "r"});
  }
  if (name.size() < 2) return;
  const char first = name.front();
  if (first == 'L' && !is_letter(name[1])) found.push_back({2, "R" + name.substr(1)});
  if (first == 'l' && !is_letter(name[1])) found.push_back({2, "r" + name.substr(1)});
}

/// cam0_17, camera1_x: a camera's number in front
void add_camera_numbers(const std::string& name, std::vector<RightName>& found) {
  for (const std::string word : {"cam0", "cam1", "camera0", "camera1"}) {
    if (!name.starts_with(word) || name.size() == word.size()) continue;
    if (is_number(name[word.size()])) continue;  // cam01
    std::string other = word;
    other.back() = static_cast<char>(other.back() + 1);
    found.push_back({1, other + name.substr(other.size())});
  }
}

/// A number at the end that counts eyes.
void add_last_numbers(const std::string& name, std::vector<RightName>& found) {
  std::size_t begin = name.size();
  while (begin > 0 && is_number(name[begin - 1])) --begin;
  if (begin == 0) return;
  constexpr std::pair<const char*, const char*> kEyes[] = {
      {"0", "1"}, {"00", "01"}, {"2", "3"}, {"02", "03"}, {"1", "2"}, {"1", "5"}, {"01", "02"}};
  const std::string last = name.substr(begin);
  int rule = 2;
  for (const auto& [left, right] : kEyes) {
    ++rule;
    if (last == left) found.push_back({rule, name.substr(0, begin) + right});
  }
}

std::vector<std::string> subfolders(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    if (entry.is_directory(error)) names.push_back(entry.path().filename().string());
  }
  std::ranges::sort(names, natural_less);
  return names;
}

/// `left/0001_left` and `right/0001_right` belong together, too.
void name_as_left_eye(std::vector<PictureEntry>& right, const std::vector<PictureEntry>& left) {
  std::set<std::string> names;
  for (const PictureEntry& entry : right) names.insert(entry.name);
  std::map<std::string, std::string> of_left;
  for (const PictureEntry& entry : left) {
    if (names.contains(entry.name)) continue;
    for (const RightName& other : right_names(entry.name)) {
      if (names.contains(other.name)) of_left.emplace(other.name, entry.name);
    }
  }
  for (PictureEntry& entry : right) {
    const auto found = of_left.find(entry.name);
    if (found != of_left.end()) entry.name = found->second;
  }
}

}  // namespace

std::vector<RightName> right_names(const std::string& left) {
  std::vector<RightName> found;
  if (left.empty()) return found;
  add_left_right(left, found);
  add_camera_numbers(left, found);
  add_letters(left, found);
  add_last_numbers(left, found);
  return found;
}

bool is_video(const fs::path& file) {
  const std::string suffix = lower_case(file.extension().string());
  constexpr const char* kVideos[] = {".mp4", ".avi",  ".mkv", ".mov", ".webm",  ".m4v",
                                     ".mpg", ".mpeg", ".ogv", ".wmv", ".mjpeg", ".mjpg"};
  return std::ranges::find(kVideos, suffix) != std::end(kVideos);
}

std::optional<PictureList> find_folder_pairs(const fs::path& folder) {
  const std::vector<std::string> names = subfolders(folder);
  for (const std::string& left_name : names) {
    for (const auto& [rule, right_name] : right_names(left_name)) {
      if (std::ranges::find(names, right_name) == names.end()) continue;
      const fs::path left = folder_of_pictures(folder / left_name);
      const fs::path right = folder_of_pictures(folder / right_name);
      if (left.empty() || right.empty()) continue;
      PictureList list;
      list.kind = fmt::format("pairs in {}/ and {}/", left_name, right_name);
      const std::vector<PictureEntry> of_left = entries_of(pictures_in(left));
      std::vector<PictureEntry> of_right = entries_of(pictures_in(right));
      name_as_left_eye(of_right, of_left);
      pair_eyes(of_left, of_right, list);
      if (list.entries.empty()) continue;
      judge_stamps(list);
      return list;
    }
  }
  return {};
}

namespace {

/// All pairs that one rule makes of the pictures of a folder.
PictureList pairs_by_rule(const std::vector<fs::path>& pictures, int rule) {
  std::map<std::string, fs::path> by_stem;
  for (const fs::path& picture : pictures) by_stem.emplace(picture.stem().string(), picture);
  PictureList list;
  std::set<std::string> used;
  for (const fs::path& picture : pictures) {
    const std::string stem = picture.stem().string();
    if (used.contains(stem)) continue;
    for (const RightName& other : right_names(stem)) {
      const auto partner = by_stem.find(other.name);
      if (other.rule != rule || partner == by_stem.end() || used.contains(other.name)) continue;
      if (list.kind.empty()) {
        list.kind = fmt::format("pairs such as {} and {}", picture.filename().string(),
                                partner->second.filename().string());
      }
      list.entries.push_back({stem, picture, partner->second, stamp_in_name(stem)});
      used.insert(stem);
      used.insert(other.name);
      break;
    }
  }
  return list;
}

}  // namespace

std::optional<PictureList> find_name_pairs(const fs::path& folder) {
  const std::vector<fs::path> pictures = pictures_in(folder);
  PictureList best;
  for (int rule = 0; rule < kNameRules; ++rule) {
    PictureList list = pairs_by_rule(pictures, rule);
    if (list.entries.size() > best.entries.size()) best = std::move(list);
  }
  // frame_0, frame_1, frame_2, ...: that two of many fit is chance
  const std::size_t used = 2 * best.entries.size();
  if (used == 0 || used * 3 < pictures.size() * 2) return {};
  if (used < pictures.size()) {
    best.remarks.push_back(
        fmt::format("{} pictures have no partner of their name: left out", pictures.size() - used));
  }
  judge_stamps(best);
  return best;
}

}  // namespace striate::datasets
