#include "striate/evaluation/object_set.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "striate/base/user_error.hpp"
#include "striate/perception/recognition/landmark_view.hpp"
#include "striate/platform/datasets/images/read_image.hpp"

namespace striate::evaluation {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// Shown where a folder holds no set
constexpr const char* kObjectLayouts =
    "expected objects/NAME/*.png, scenes/*.png and truth.json ({\"scene\": [\"NAME\", ...]}),\n"
    "or JSK ARC 2017 (objects/NAME/top.jpg, scenes/*.jpg, visual_annotation.json),\n"
    "or pairs NAME.png, NAME_in_scene.png";

/// In the order of their names; a folder that is not there has none.
std::vector<fs::path> entries(const fs::path& folder, bool folders) {
  std::vector<fs::path> result;
  std::error_code missing;
  for (const auto& entry : fs::directory_iterator(folder, missing)) {
    if (folders ? entry.is_directory() : datasets::is_image(entry.path()))
      result.push_back(entry.path());
  }
  std::ranges::sort(result);
  return result;
}

json read_json(const fs::path& path) {
  std::ifstream file(path);
  try {
    return json::parse(file);
  } catch (const json::exception& error) {
    throw UserError(path.string() + ": " + error.what());
  }
}

std::set<std::string> names_at(const json& truth, const std::string& scene) {
  const auto found = truth.find(scene);
  if (found == truth.end()) return {};
  try {
    return found->get<std::set<std::string>>();
  } catch (const json::exception&) {
    throw UserError(fmt::format("truth of scene '{}': a list of names is expected", scene));
  }
}

TaughtImage taught(const fs::path& path) {
  TaughtImage image;
  image.grey = datasets::read_any_grey(path);
  image.region = region_of_object(image.grey);
  // As `striate teach` shrinks what it learns from, for all methods alike.
  const double scale = static_cast<double>(perception::kLongestView_px) /
                       std::max(image.region.width, image.region.height);
  if (scale >= 1.0) return image;
  const cv::Mat1b large = image.grey(image.region);
  cv::resize(large, image.grey, {}, scale, scale, cv::INTER_AREA);
  image.region = {0, 0, image.grey.cols, image.grey.rows};
  return image;
}

/// The other views of an object show it among other things: only the one on black is taught. What
/// has no info.json is a container.
void read_jsk_objects(const fs::path& folder, ObjectSet& set) {
  for (const fs::path& path : entries(folder / "objects", true)) {
    if (!fs::exists(path / "info.json")) continue;
    set.objects.push_back({path.filename().string(), {taught(path / "top.jpg")}});
  }
}

void read_plain_objects(const fs::path& folder, ObjectSet& set) {
  for (const fs::path& path : entries(folder / "objects", true)) {
    TaughtObject object{path.filename().string(), {}};
    for (const fs::path& image : entries(path, false)) object.pictures.push_back(taught(image));
    if (!object.pictures.empty()) set.objects.push_back(std::move(object));
  }
}

void read_scenes(const fs::path& folder, const json& truth, ObjectSet& set) {
  for (const fs::path& path : entries(folder / "scenes", false)) {
    const std::string stem = path.stem().string();
    ObjectScene scene{
        path.filename().string(), datasets::read_any_grey(path), names_at(truth, stem), {}};
    scene.present.merge(names_at(truth, path.filename().string()));
    if (truth.contains("back")) scene.not_judged = names_at(truth["back"], stem);
    for (const std::string& name : scene.not_judged) scene.present.erase(name);
    set.scenes.push_back(std::move(scene));
  }
}

void read_pairs(const fs::path& folder, ObjectSet& set) {
  for (const fs::path& path : entries(folder, false)) {
    const std::string name = path.stem().string();
    const fs::path scene = folder / (name + "_in_scene" + path.extension().string());
    if (!fs::exists(scene)) continue;
    set.objects.push_back({name, {taught(path)}});
    set.scenes.push_back({scene.filename().string(), datasets::read_any_grey(scene), {name}, {}});
  }
}

}  // namespace

cv::Rect region_of_object(const cv::Mat1b& grey) {
  const cv::Rect all(0, 0, grey.cols, grey.rows);
  constexpr int kAlike = 8;  // grey levels; what JPEG leaves on a black background (ours)
  const int background = grey(0, 0);
  for (const int other :
       {grey(0, grey.cols - 1), grey(grey.rows - 1, 0), grey(grey.rows - 1, grey.cols - 1)}) {
    if (std::abs(other - background) > kAlike) return all;
  }
  cv::Mat1b difference;
  cv::absdiff(grey, cv::Scalar(background), difference);
  // Specks of noise and of compression are no part of the object.
  cv::medianBlur(difference, difference, 5);
  const cv::Rect part = cv::boundingRect(cv::Mat1b(difference > 2 * kAlike));
  return part.area() > 0 ? part : all;
}

ObjectSet read_object_set(const std::string& folder) {
  const fs::path root(folder);
  ObjectSet set;
  if (fs::exists(root / "visual_annotation.json")) {
    read_jsk_objects(root, set);
    read_scenes(root, read_json(root / "visual_annotation.json"), set);
  } else if (fs::exists(root / "truth.json")) {
    read_plain_objects(root, set);
    read_scenes(root, read_json(root / "truth.json"), set);
  } else {
    read_pairs(root, set);
  }
  if (set.objects.empty() || set.scenes.empty()) {
    throw UserError(fmt::format("{}: no objects and scenes found; {}", folder, kObjectLayouts));
  }
  return set;
}

}  // namespace striate::evaluation
