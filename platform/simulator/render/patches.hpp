#pragma once

#include <array>
#include <vector>

#include "striate/base/geometry.hpp"
#include "striate/platform/simulator/render/materials.hpp"
#include "striate/platform/simulator/render/vec.hpp"

/// The world as flat quadrilaterals. Each carries a texture and a small map of baked light, so a
/// wall of many metres is one patch however finely it is lit.
namespace striate::simulator::render {

/// Corners counter-clockwise as seen from the lit side. Embree's (u, v) run 0 -> 1 and 0 -> 3; the
/// half beyond the diagonal 1-3 is measured from corner 2, and so are texture and light here.
struct Patch {
  std::array<Vec3, 4> corner;
  Vec3 normal;
  /// Which way the surface faces at its corners, for its light: round things are round to light.
  std::array<Vec3, 4> bend;
  std::array<float, 4> s{};  ///< texture coordinates of the corners, in repeats
  std::array<float, 4> t{};
  int material = 0;
  int group = 0;  ///< what is one surface to the eye: no edge between patches of one group
  float texels_per_m = 0.0F;
  int light_at = 0;  ///< first texel of the light map; rows run along v
  int light_u = 2;   ///< texels along u and v, at least 2: the outer ones lie on the border
  int light_v = 2;
  bool may_see_sun = false;

  /// Piecewise as above, for texture coordinates or places.
  template <class T>
  static T at(const std::array<T, 4>& c, float u, float v) {
    if (u + v <= 1.0F) return c[0] + (c[1] - c[0]) * u + (c[3] - c[0]) * v;
    return c[2] + (c[3] - c[2]) * (1.0F - u) + (c[1] - c[2]) * (1.0F - v);
  }
};

/// A place to put things: plan pose and height of the floor they stand on.
struct Stand {
  Pose2 pose;
  float z_m = 0.0F;
  /// A point given in this frame, in the world.
  [[nodiscard]] Vec3 point(float x, float y, float z) const {
    const Point2 p = transform(pose, Point2{x, y});
    return {static_cast<float>(p.x_m), static_cast<float>(p.y_m), z + z_m};
  }
};

struct Block {  ///< a box in a Stand's frame
  Vec3 low;
  Vec3 high;
};

struct Column {  ///< upright and round, in a Stand's frame; may be a cone or an ellipse
  float x_m = 0.0F;
  float y_m = 0.0F;
  float bottom_m = 0.0F;
  float top_m = 0.0F;
  float bottom_rx_m = 0.0F;
  float bottom_ry_m = 0.0F;
  float top_rx_m = 0.0F;
  float top_ry_m = 0.0F;
  int sides = 16;
  bool lid = false;
};

/// Collects patches. `spacing_m`: of the light map's texels.
class PatchList {
 public:
  explicit PatchList(Materials& materials) : materials_(materials) {}

  void next_group() { ++group_; }
  void set_spacing(float spacing_m) { spacing_m_ = spacing_m; }

  /// Texture coordinates are given in metres (or 0..1 for images) as s right, t down.
  Patch& quad(const std::array<Vec3, 4>& corner, int material, const std::array<float, 4>& s,
              const std::array<float, 4>& t);
  /// An upright or lying rectangle: corner, its two edges; the texture's s runs along `along`,
  /// t against `up`, starting at (s_m, t_m) in the lower left.
  Patch& rectangle(Vec3 corner, Vec3 along, Vec3 up, int material, float s_m = 0.0F);
  /// All sides but the bottom, each a group of its own.
  void block(const Stand& stand, const Block& block, int side_material, int top_material,
             bool with_bottom = false);
  void column(const Stand& stand, const Column& column, int material);

  [[nodiscard]] const std::vector<Patch>& all() const { return patches_; }
  [[nodiscard]] std::vector<Patch> take() { return std::move(patches_); }
  [[nodiscard]] int light_texels() const { return light_texels_; }
  [[nodiscard]] Materials& materials() { return materials_; }

 private:
  Materials& materials_;
  std::vector<Patch> patches_;
  int group_ = 0;
  int light_texels_ = 0;
  float spacing_m_ = 0.15F;
};

}  // namespace striate::simulator::render
