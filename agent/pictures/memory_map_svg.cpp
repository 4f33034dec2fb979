#include "striate/agent/pictures/memory_map_svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

#include "striate/base/geometry.hpp"
#include "striate/base/plain_text.hpp"
#include "striate/base/user_error.hpp"

namespace striate::agent::pictures {
namespace {

/// px: the longer side of a map fits a full HD screen's height when shown at 90 %
constexpr double kSide_px = 1200.0;
constexpr double kMargin_px = 60.0;  ///< px around: labels at the border fit
constexpr double kEllipse = 2.45;    ///< standard deviations that hold 95 % in two dimensions

/// Map x to the right, y up.
class MapSvg {
 public:
  void cover(double x_m, double y_m) {
    left_m_ = std::min(left_m_, x_m);
    right_m_ = std::max(right_m_, x_m);
    low_m_ = std::min(low_m_, y_m);
    top_m_ = std::max(top_m_, y_m);
  }

  void begin() {
    if (!(left_m_ <= right_m_)) {
      throw UserError("the map is empty: no landmark has a position yet, and no obstacle is kept");
    }
    px_per_m_ =
        (kSide_px - 2.0 * kMargin_px) / std::max({1.0, right_m_ - left_m_, top_m_ - low_m_});
    const double height_px = 2.0 * kMargin_px + std::max(60.0, (top_m_ - low_m_) * px_per_m_);
    svg_ = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {:.0f} {:.0f}\" "
        "font-family=\"sans-serif\" font-size=\"13\">\n"
        "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n"
        "<defs><marker id=\"arrow\" viewBox=\"0 0 8 8\" refX=\"8\" refY=\"4\" markerWidth=\"8\" "
        "markerHeight=\"8\" orient=\"auto\"><path d=\"M0 0 L8 4 L0 8 z\" fill=\"#777\"/></marker>"
        "</defs>\n",
        kSide_px, height_px);
    svg_ += fmt::format(
        "<path d=\"M{0} {1:.1f} h{2:.2f}\" stroke=\"#333\" stroke-width=\"2\"/>\n"
        "<text x=\"{0}\" y=\"{3:.1f}\">1 m</text>\n",
        kMargin_px, height_px - 16.0, px_per_m_, height_px - 22.0);
  }

  /// Cells of one row that say the same are one rectangle.
  void cells(const std::vector<memory::ObstacleCell>& cells) {
    for (std::size_t k = 0; k < cells.size();) {
      const bool stands = cells[k].log_odds > 0.0;
      std::size_t end = k + 1;
      while (end < cells.size() && cells[end].row == cells[k].row &&
             cells[end].column == cells[end - 1].column + 1 &&
             (cells[end].log_odds > 0.0) == stands) {
        ++end;
      }
      svg_ += fmt::format(
          "<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" fill=\"{}\"/>\n",
          x(cells[k].column * memory::kObstacleCell_m),
          y((cells[k].row + 1) * memory::kObstacleCell_m),
          static_cast<double>(end - k) * memory::kObstacleCell_m * px_per_m_,
          memory::kObstacleCell_m * px_per_m_, stands ? "#a03c3c" : "#dcebdc");
      k = end;
    }
  }

  void route(const memory::MapPosition& from, const memory::MapPosition& to) {
    svg_ += fmt::format(
        "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"#777\" "
        "marker-end=\"url(#arrow)\"/>\n",
        x(from.x_m), y(from.y_m), x(to.x_m), y(to.y_m));
  }

  void landmark(const std::string& name, const memory::MapPosition& at) {
    const double mean = (at.var_x_m2 + at.var_y_m2) / 2.0;
    const double spread = std::hypot((at.var_x_m2 - at.var_y_m2) / 2.0, at.cov_xy_m2);
    const double angle_rad = 0.5 * std::atan2(2.0 * at.cov_xy_m2, at.var_x_m2 - at.var_y_m2);
    const auto axis_px = [&](double variance_m2) {
      return std::max(1.0, kEllipse * std::sqrt(std::max(0.0, variance_m2)) * px_per_m_);
    };
    svg_ += fmt::format(
        "<ellipse rx=\"{:.2f}\" ry=\"{:.2f}\" transform=\"translate({:.1f} {:.1f}) "
        "rotate({:.1f})\" fill=\"none\" stroke=\"#d07a00\"/>\n",
        axis_px(mean + spread), axis_px(mean - spread), x(at.x_m), y(at.y_m), -degrees(angle_rad));
    svg_ += fmt::format(
        "<circle cx=\"{0:.1f}\" cy=\"{1:.1f}\" r=\"4\" fill=\"#0b62a4\"/>"
        "<text x=\"{2:.1f}\" y=\"{3:.1f}\">{4}</text>\n",
        x(at.x_m), y(at.y_m), x(at.x_m) + 7.0, y(at.y_m) - 7.0, xml_text(name));
  }

  [[nodiscard]] std::string end() { return svg_ + "</svg>\n"; }

 private:
  [[nodiscard]] double x(double x_m) const { return kMargin_px + (x_m - left_m_) * px_per_m_; }
  [[nodiscard]] double y(double y_m) const { return kMargin_px + (top_m_ - y_m) * px_per_m_; }

  static constexpr double kNone = std::numeric_limits<double>::infinity();  // m: nothing drawn yet
  double left_m_ = kNone, right_m_ = -kNone, low_m_ = kNone, top_m_ = -kNone;
  double px_per_m_ = 1.0;
  std::string svg_;
};

}  // namespace

std::string memory_map_svg(const std::vector<memory::Landmark>& landmarks,
                           const std::vector<memory::Route>& routes,
                           const std::vector<memory::ObstacleCell>& cells) {
  MapSvg map;
  std::unordered_map<std::int64_t, memory::MapPosition> places;
  for (const memory::Landmark& one : landmarks) {
    if (!one.position) continue;
    places[one.id] = *one.position;
    map.cover(one.position->x_m, one.position->y_m);
  }
  for (const memory::ObstacleCell& one : cells) {
    map.cover(one.column * memory::kObstacleCell_m, one.row * memory::kObstacleCell_m);
  }
  map.begin();
  map.cells(cells);
  for (const memory::Route& one : routes) {
    const auto from = places.find(one.from);
    const auto to = places.find(one.to);
    if (from != places.end() && to != places.end()) map.route(from->second, to->second);
  }
  for (const memory::Landmark& one : landmarks) {
    if (one.position) map.landmark(one.name, *one.position);
  }
  return map.end();
}

}  // namespace striate::agent::pictures
