#pragma once

#include <vector>

namespace striate::perception {

/// A place with the distance within which it suffers no weaker one.
struct FoundPlace {
  double u_px = 0.0;
  double v_px = 0.0;
  double radius_px = 0.0;
};

/// Of places in descending order of strength, keeps those that no stronger kept one of about the
/// same radius (between half and twice) is near: nearer than the larger of their radii. Keeps its
/// buffers.
class KeepApart {
 public:
  /// Forgets all places; they will be within 0..width, 0..height.
  /// @param finest_radius_px the smallest that will come; radii grow by sqrt(2) from there.
  void begin(int width, int height, double finest_radius_px, int scales);

  /// True, and the place is noted, where nothing stronger is near. @param scale of its radius.
  bool keep(const FoundPlace& place, int scale);

 private:
  struct Noted {
    FoundPlace place;
    int next = -1;  ///< in the same cell
  };
  struct Grid {
    double cell_px = 1.0;
    int columns = 0, rows = 0;
    std::vector<int> first;  ///< of each cell's chain, in noted_
  };
  [[nodiscard]] bool is_near(const FoundPlace& place, const Grid& grid) const;

  std::vector<Grid> grids_;  ///< one a scale
  std::vector<Noted> noted_;
};

}  // namespace striate::perception
