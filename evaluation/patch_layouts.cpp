#include "striate/evaluation/patch_layouts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <sstream>

#include "striate/base/user_error.hpp"
#include "striate/evaluation/sequence_patches.hpp"
#include "striate/platform/datasets/images/read_image.hpp"

namespace striate::evaluation {
namespace {

namespace fs = std::filesystem;

/// Shown where a folder holds no patches
constexpr const char* kExpected =
    "expected one of: folders with img1.png ... and H1to2p ... (Oxford), with 1.ppm ... and "
    "H_1_2 ... (HPatches), or info.txt, m50_*.txt and mosaics of patches (Brown/Winder)";

[[noreturn]] void wrong_line(const fs::path& path, int line, const char* expected) {
  throw UserError(fmt::format("{}:{}: expected {}", path.string(), line, expected));
}

/// How many patches there are: one line each, beginning with the number of its 3-D point.
int read_info(const fs::path& path) {
  std::ifstream file(path);
  int lines = 0;
  for (std::string line; std::getline(file, line);) {
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    ++lines;
    int point = 0;
    if (!(std::istringstream(line) >> point)) wrong_line(path, lines, "the number of a 3-D point");
  }
  return lines;
}

/// Lines: patch, its 3-D point, unused, patch, its 3-D point, ... Same point: the same place.
std::vector<PatchPair> read_matches(const fs::path& path, int count) {
  std::ifstream file(path);
  std::vector<PatchPair> pairs;
  int number = 0;
  for (std::string line; std::getline(file, line);) {
    ++number;
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    int a = 0, point_a = 0, unused = 0, b = 0, point_b = 0;
    if (!(std::istringstream(line) >> a >> point_a >> unused >> b >> point_b)) {
      wrong_line(path, number, "patch, point, unused, patch, point");
    }
    if (a < 0 || b < 0 || a >= count || b >= count) {
      wrong_line(path, number, fmt::format("patches 0 to {}", count - 1).c_str());
    }
    pairs.push_back({a, b, point_a == point_b});
  }
  return pairs;
}

/// Of several files of pairs the one that comes nearest to what is wanted.
fs::path best_matches_file(const fs::path& folder, int pairs) {
  fs::path best;
  std::uintmax_t best_size = 0;
  const std::string exact = fmt::format("m50_{0}_{0}_0.txt", pairs);
  for (const fs::path& entry : sorted_entries(folder)) {
    const std::string name = entry.filename().string();
    if (!name.starts_with("m50_") || entry.extension() != ".txt") continue;
    if (name == exact) return entry;
    if (best.empty() || fs::file_size(entry) > best_size)
      best = entry, best_size = fs::file_size(entry);
  }
  return best;
}

PatchSet from_mosaics(const fs::path& folder, const PatchChoice& choice) {
  PatchSet set;
  set.count = read_info(folder / "info.txt");
  const fs::path matches = best_matches_file(folder, choice.pairs);
  if (matches.empty())
    throw UserError(fmt::format("{}: no m50_*.txt; {}", folder.string(), kExpected));
  int same = 0, different = 0;
  for (const PatchPair& pair : read_matches(matches, set.count)) {
    if ((pair.same ? same : different)++ < choice.pairs) set.pairs.push_back(pair);
  }
  constexpr int kPatches = kMosaicPatches * kMosaicPatches;  // in one mosaic
  const auto wanted = static_cast<std::size_t>((set.count + kPatches - 1) / kPatches);
  for (const fs::path& entry : sorted_entries(folder)) {
    if (set.mosaics.size() == wanted) break;
    if (!datasets::is_image(entry)) continue;
    set.mosaics.push_back(datasets::read_any_grey(entry));
    if (set.mosaics.back().size() != cv::Size(1024, 1024)) {
      throw UserError(fmt::format("{}: expected 1024x1024 px", entry.string()));
    }
  }
  if (set.mosaics.size() < wanted) {
    throw UserError(fmt::format("{}: info.txt tells of {} patches, which are {} mosaics; {} found",
                                folder.string(), set.count, wanted, set.mosaics.size()));
  }
  return set;
}

}  // namespace

PatchSet load_patches(const std::string& folder, const PatchChoice& choice) {
  if (!fs::is_directory(folder)) {
    throw UserError(fmt::format("{}: no folder; {}", folder, kExpected));
  }
  if (fs::exists(fs::path(folder) / "info.txt")) return from_mosaics(folder, choice);
  std::vector<SequencePair> pictures = image_pairs(folder);
  for (const fs::path& entry : sorted_entries(folder)) {
    if (!fs::is_directory(entry)) continue;
    const auto more = image_pairs(entry);
    pictures.insert(pictures.end(), more.begin(), more.end());
  }
  if (pictures.empty()) throw UserError(fmt::format("{}: nothing to read; {}", folder, kExpected));
  PatchSet set = from_sequences(pictures, choice);
  if (set.pairs.empty()) {
    throw UserError(fmt::format("{}: no SIFT frame was found again in any image", folder));
  }
  return set;
}

}  // namespace striate::evaluation
