#include "striate/evaluation/calibration/board_images.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "striate/base/user_error.hpp"
#include "striate/platform/datasets/images/read_image.hpp"

namespace striate::evaluation {
namespace {

namespace fs = std::filesystem;

/// Shown where a folder holds no pairs
constexpr const char* kBoardLayout =
    "\n  hint: FOLDER/left/*.png and FOLDER/right/*.png with the same names, or with "
    "--side-by-side FOLDER/*.png; also .jpg, .jpeg, .pgm, .bmp, .tif, .webp";

/// By their names without suffix.
std::map<std::string, fs::path> board_pictures(const fs::path& folder) {
  std::map<std::string, fs::path> found;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    if (!datasets::is_image(entry.path())) continue;
    const auto [there, is_new] = found.emplace(entry.path().stem().string(), entry.path());
    if (is_new) continue;
    throw UserError(fmt::format(
        "{}: is there beside {}: nobody can tell which of them belongs to the other eye's",
        std::max(entry.path(), there->second).string(),
        std::min(entry.path(), there->second).filename().string()));
  }
  if (error) throw UserError(folder.string() + ": " + error.message() + kBoardLayout);
  if (found.empty()) throw UserError(folder.string() + ": no images" + kBoardLayout);
  return found;
}

void add_unpaired(const char* eye, const std::map<std::string, fs::path>& mine,
                  const std::map<std::string, fs::path>& others, BoardFolder& found) {
  for (const auto& [name, file] : mine) {
    if (others.count(name) > 0) continue;
    found.unpaired.push_back(fmt::format("{}/{}", eye, file.filename().string()));
  }
}

}  // namespace

BoardFolder find_board_images(const fs::path& folder, bool side_by_side) {
  BoardFolder found;
  const auto left = board_pictures(side_by_side ? folder : folder / "left");
  if (side_by_side) {
    for (const auto& [name, file] : left) {
      found.looks.push_back({file.filename().string(), file, {}});
    }
    return found;
  }
  const auto right = board_pictures(folder / "right");
  for (const auto& [name, file] : left) {
    const auto partner = right.find(name);
    if (partner == right.end()) continue;
    found.looks.push_back({file.filename().string(), file, partner->second});
  }
  add_unpaired("left", left, right, found);
  add_unpaired("right", right, left, found);
  if (found.looks.empty()) {
    throw UserError(
        fmt::format("{}: no left image has a right one of the same name; there are {} "
                    "and {}{}",
                    folder.string(), found.unpaired.front(), found.unpaired.back(), kBoardLayout));
  }
  return found;
}

}  // namespace striate::evaluation
