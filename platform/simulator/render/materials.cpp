#include "striate/platform/simulator/render/materials.hpp"

#include <filesystem>
#include <opencv2/imgcodecs.hpp>

#include "striate/base/user_error.hpp"
#include "striate/config/configuration_path.hpp"
#include "striate/config/quantity.hpp"
#include "striate/platform/interface/pixel_range.hpp"
#include "striate/platform/simulator/render/paint.hpp"

namespace striate::simulator::render {

namespace fs = std::filesystem;

std::vector<std::string> material_names() {
  std::vector<std::string> names;
  for (const Surface& surface : surfaces()) names.push_back(surface.name);
  for (const Picture& picture : pictures()) names.push_back(picture.name);
  return names;
}

int Materials::add(const std::string& name, Material material) {
  const int number = static_cast<int>(all_.size());
  all_.push_back(std::move(material));
  number_[name] = number;
  return number;
}

std::string Materials::file_of(const std::string& name) const {
  std::error_code ignored;
  if (fs::is_regular_file(name, ignored)) return name;
  const fs::path beside = fs::path(world_file_).parent_path() / name;
  if (fs::is_regular_file(beside, ignored)) return beside.string();
  return config::find_in_configuration(name, config::FileKind::world);
}

int Materials::find(const std::string& name, const std::string& for_what) {
  if (const auto known = number_.find(name); known != number_.end()) return known->second;
  Material material;
  for (const Surface& surface : surfaces()) {
    if (surface.name != name) continue;
    material.texture = std::make_shared<Texture>(surface.paint());
    material.tile_x_m = static_cast<float>(surface.tile_x_m);
    material.tile_y_m = static_cast<float>(surface.tile_y_m);
    material.gloss = static_cast<float>(surface.gloss);
    return add(name, std::move(material));
  }
  for (const Picture& picture : pictures()) {
    if (picture.name != name) continue;
    material.texture = std::make_shared<Texture>(picture.paint());
    return add(name, std::move(material));
  }
  const std::string place = world_file_.empty() ? std::string() : world_file_ + ": ";
  const std::string file = file_of(name);
  if (file.empty()) {
    const std::string hint = config::suggest(name, material_names());
    throw UserError(place + "'" + name + "' of a " + for_what +
                    " is no shipped material and no image file" +
                    (hint.empty() ? std::string() : "; " + hint));
  }
  cv::Mat picture = cv::imread(file, cv::IMREAD_COLOR | cv::IMREAD_ANYDEPTH);
  if (picture.depth() > CV_16U) picture = cv::imread(file, cv::IMREAD_COLOR);  // of floats
  if (picture.empty()) {
    throw UserError(place + "'" + file + "' of a " + for_what + " cannot be read as an image");
  }
  const cv::Mat3b image = as_eight_bits(picture, most_of_bits(bits_used(picture)));
  material.texture = std::make_shared<Texture>(image);
  return add(name, std::move(material));
}

int Materials::wet(const std::string& floor) {
  const std::string name = "wet " + floor;
  if (const auto known = number_.find(name); known != number_.end()) return known->second;
  // Wet stone, wood and cloth throw back about six tenths of what they do when dry (Lekner and
  // Dorf 1988 explain why); paint is about the square root of that.
  constexpr double kDarker = 0.77;
  // Of the mirror's formula, which gives a twenty-fifth straight down and all of it grazing: water.
  constexpr float kWater = 1.0F;
  Material material = all_[static_cast<std::size_t>(find(floor, "floor"))];
  for (const Surface& surface : surfaces()) {
    if (surface.name != floor) continue;
    cv::Mat3b paint = surface.paint();
    paint *= kDarker;
    material.texture = std::make_shared<Texture>(paint);
  }
  material.gloss = kWater;
  return add(name, std::move(material));
}

int Materials::lamp(float exitance) {
  const std::string name = "lamp " + std::to_string(exitance);
  if (const auto known = number_.find(name); known != number_.end()) return known->second;
  Material material;
  material.texture = std::make_shared<Texture>(cv::Mat3b(2, 2, cv::Vec3b(255, 255, 255)));
  material.tile_x_m = material.tile_y_m = 1.0F;
  material.shines = true;
  material.emission = bgr(0.93F, 1.0F, 0.98F) * splat(exitance);
  return add(name, std::move(material));
}

}  // namespace striate::simulator::render
