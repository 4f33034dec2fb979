#pragma once

#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include "striate/platform/simulator/render/texture.hpp"

namespace striate::simulator::render {

struct Material {
  std::shared_ptr<const Texture> texture;
  float tile_x_m = 0.0F;  ///< of one repeat; 0: stretched over what carries it
  float tile_y_m = 0.0F;
  float gloss = 0.0F;
  bool shines = false;
  V4 emission{};  ///< of lamps: exitance in units of the irradiance of a bright office
};

/// The materials that one world uses, made when first asked for.
class Materials {
 public:
  /// `world_file`: image files are looked for as named, then beside this file, then among the
  /// worlds of a configuration (config/configuration_path.hpp).
  explicit Materials(std::string world_file) : world_file_(std::move(world_file)) {}

  /// The number of a shipped surface or picture, or of an image file. Throws UserError for a name
  /// that is neither, with the nearest shipped one. `for_what` stands in the message: "wall".
  int find(const std::string& name, const std::string& for_what);
  /// A floor of this material with water on it: darker, and as much of a mirror as water is.
  int wet(const std::string& floor);
  /// A lamp's panel.
  int lamp(float exitance);

  [[nodiscard]] const std::vector<Material>& all() const { return all_; }
  [[nodiscard]] const Material& operator[](int i) const {
    return all_[static_cast<std::size_t>(i)];
  }

 private:
  int add(const std::string& name, Material material);
  [[nodiscard]] std::string file_of(const std::string& name) const;

  std::string world_file_;
  std::vector<Material> all_;
  std::unordered_map<std::string, int> number_;
};

/// Every shipped surface's and picture's name.
[[nodiscard]] std::vector<std::string> material_names();

}  // namespace striate::simulator::render
