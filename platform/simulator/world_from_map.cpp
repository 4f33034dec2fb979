#include "striate/platform/simulator/world_from_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <utility>
#include <vector>

#include "striate/base/user_error.hpp"

namespace striate::simulator {
namespace {

constexpr double kMargin_m = 0.3;         // between the picture's rim and the outer walls (ours)
constexpr int kSpeck = 4;                 // cells: what a scanner sees of dust and legs (ours)
constexpr std::size_t kMostWalls = 4000;  // pieces of masonry; more take long to light (ours)
constexpr double kLampEvery_m = 3.5;      // as in the shipped short corridor
/// A Pioneer turns on the spot within 0.37 m (its rear corner), and some to spare.
constexpr double kRoom_m = 0.45;
/// Half of the least way of a drivable world, 0.75 m.
constexpr double kHalfWay_m = 0.375;

cv::Mat1b without_specks(const cv::Mat1b& stands) {
  cv::Mat1i labels, stats;
  cv::Mat centres;
  const int count = cv::connectedComponentsWithStats(stands, labels, stats, centres, 8);
  cv::Mat1b kept = stands.clone();
  for (int row = 0; row < kept.rows; ++row) {
    for (int column = 0; column < kept.cols; ++column) {
      const int label = labels(row, column);
      if (label > 0 && label < count && stats(label, cv::CC_STAT_AREA) < kSpeck) {
        kept(row, column) = 0;
      }
    }
  }
  return kept;
}

/// Rectangles that cover all that stands, each as long as its first row allows.
std::vector<cv::Rect> rectangles(cv::Mat1b left_over) {
  std::vector<cv::Rect> all;
  for (int row = 0; row < left_over.rows; ++row) {
    for (int column = 0; column < left_over.cols; ++column) {
      if (left_over(row, column) == 0) continue;
      int to = column;
      while (to < left_over.cols && left_over(row, to) != 0) ++to;
      int below = row + 1;
      const auto full = [&](int at) {
        return cv::countNonZero(left_over(cv::Range(at, at + 1), cv::Range(column, to))) ==
               to - column;
      };
      while (below < left_over.rows && full(below)) ++below;
      all.emplace_back(column, row, to - column, below - row);
      left_over(all.back()) = 0;
      if (all.size() > kMostWalls) {
        throw UserError(
            fmt::format("the map has more than {} pieces of wall\n    draw it with "
                        "larger cells, or remove what is no wall",
                        kMostWalls));
      }
    }
  }
  return all;
}

class Builder {
 public:
  Builder(const FloorPicture& picture, std::string name) : cell_m_(picture.cell_m) {
    made_.world.name = std::move(name);
    made_.turned = picture.stands.rows > picture.stands.cols;
    stands_ = without_specks(picture.stands != 0);
    const cv::Mat1b specks = (picture.stands != 0) & ~stands_;
    free_ = ((picture.free != 0) | specks) & ~stands_;
    Point2 origin = picture.origin;
    if (made_.turned) {
      // (x, y) becomes (y, -x).
      cv::rotate(stands_, stands_, cv::ROTATE_90_COUNTERCLOCKWISE);
      cv::rotate(free_, free_, cv::ROTATE_90_COUNTERCLOCKWISE);
      origin = {picture.origin.y_m, -picture.origin.x_m - picture.stands.cols * cell_m_};
    }
    const double half_width_m = 0.5 * stands_.rows * cell_m_;
    made_.moved = {kMargin_m - origin.x_m, -half_width_m - origin.y_m};
    made_.world.length_m = stands_.cols * cell_m_ + 2.0 * kMargin_m;
    made_.world.width_m = 2.0 * (half_width_m + kMargin_m);
  }

  MapWorld build(std::optional<Pose2> asked) {
    check_size();
    walls();
    find_reachable(asked);
    lamps();
    return std::move(made_);
  }

 private:
  [[nodiscard]] Point2 middle_of(double column, double row) const {
    return {kMargin_m + (column + 0.5) * cell_m_, (row + 0.5 - 0.5 * stands_.rows) * cell_m_};
  }
  /// A place of the map, in the world.
  [[nodiscard]] Point2 place_of(const Pose2& of_map) const {
    const Point2 place =
        made_.turned ? Point2{of_map.y_m, -of_map.x_m} : Point2{of_map.x_m, of_map.y_m};
    return {place.x_m + made_.moved.x_m, place.y_m + made_.moved.y_m};
  }
  [[nodiscard]] cv::Point cell_at(Point2 place) const {
    return {static_cast<int>(std::floor((place.x_m - kMargin_m) / cell_m_)),
            static_cast<int>(std::floor(place.y_m / cell_m_ + 0.5 * stands_.rows))};
  }

  void check_size() const {
    constexpr double kLongest_m = 1000.0;  // of a corridor of the world language
    constexpr double kWidest_m = 50.0;     // of a corridor of the world language
    const World& world = made_.world;
    if (world.length_m <= kLongest_m && world.width_m <= kWidest_m) return;
    throw UserError(
        fmt::format("the map is {:.0f} m x {:.0f} m; a world is at most {:.0f} m long "
                    "and {:.0f} m wide\n    cut out the part that is to be driven",
                    world.length_m, world.width_m, kLongest_m, kWidest_m));
  }

  void walls() {
    for (const cv::Rect& piece : rectangles(stands_.clone())) {
      WorldObstacle wall;
      wall.kind = ObstacleKind::wall;
      wall.at = middle_of(piece.x + 0.5 * (piece.width - 1), piece.y + 0.5 * (piece.height - 1));
      wall.size_x_m = piece.width * cell_m_;
      wall.size_y_m = piece.height * cell_m_;
      wall.size_z_m = made_.world.height_m;
      made_.world.obstacles.push_back(wall);
    }
    for (std::size_t i = 0; i < made_.world.obstacles.size(); ++i) {
      made_.world.obstacles[i].name = fmt::format("wall_{}", i + 1);
    }
  }

  /// Start, and the goal line before the farthest place that can be reached from it.
  void find_reachable(std::optional<Pose2> asked) {
    const cv::Mat1f clearance_m = clearance();
    cv::Mat1i areas;
    const cv::Mat1b passable = clearance_m > kHalfWay_m;
    const int count = cv::connectedComponents(passable, areas, 8);
    const cv::Mat1b roomy = clearance_m > kRoom_m;
    const cv::Point start =
        asked ? asked_start(*asked, roomy) : first_room(areas, count, roomy, clearance_m);
    const int area = areas(start);
    int farthest = start.x;
    for (int column = 0; column < areas.cols; ++column) {
      if (cv::countNonZero(areas.col(column) == area) > 0) farthest = std::max(farthest, column);
    }
    World& world = made_.world;
    const Point2 at = asked ? place_of(*asked) : middle_of(start.x, start.y);
    world.start = {at.x_m, at.y_m, asked ? turned(asked->heading_rad) : longest_view(start)};
    world.goal_beyond_m = middle_of(farthest, 0).x_m - kHalfWay_m;
    if (world.goal_beyond_m <= world.start.x_m) {
      throw UserError(
          "from the start nothing farther along the map can be reached\n    choose "
          "another start: --at \"x, y, heading\" in the map's own frame");
    }
  }

  /// From what is not known to be free, and so from the picture's rim, too.
  [[nodiscard]] cv::Mat1f clearance() const {
    cv::Mat1b with_rim;
    cv::copyMakeBorder(free_, with_rim, 1, 1, 1, 1, cv::BORDER_CONSTANT, cv::Scalar(0));
    cv::Mat1f cells;
    cv::distanceTransform(with_rim, cells, cv::DIST_L2, cv::DIST_MASK_PRECISE);
    return cell_m_ * cells(cv::Rect({1, 1}, free_.size()));
  }

  [[nodiscard]] double turned(double heading_rad) const {
    return wrap_angle(made_.turned ? heading_rad - kPi / 2.0 : heading_rad);
  }

  [[nodiscard]] cv::Point asked_start(const Pose2& asked, const cv::Mat1b& roomy) const {
    const cv::Point cell = cell_at(place_of(asked));
    if (!cv::Rect({0, 0}, roomy.size()).contains(cell) || roomy(cell) == 0) {
      throw UserError(
          fmt::format("at {:.2f} m, {:.2f} m the map has not {:.2f} m of free floor to "
                      "all sides, which a Pioneer needs to start",
                      asked.x_m, asked.y_m, kRoom_m));
    }
    return cell;
  }

  /// In the largest part that can be driven, the roomiest place of the first metres along the map.
  [[nodiscard]] cv::Point first_room(const cv::Mat1i& areas, int count, const cv::Mat1b& roomy,
                                     const cv::Mat1f& clearance_m) const {
    constexpr double kFirst_m = 2.0;  // from the first place with room (ours)
    std::vector<int> sizes(static_cast<std::size_t>(count), 0);
    for (const int area : areas) sizes[static_cast<std::size_t>(area)] += area > 0 ? 1 : 0;
    const auto largest = static_cast<int>(std::ranges::max_element(sizes) - sizes.begin());
    std::optional<cv::Point> best;
    int last = areas.cols;
    for (int column = 0; column < std::min(last, areas.cols); ++column) {
      for (int row = 0; row < areas.rows; ++row) {
        if (areas(row, column) != largest || largest == 0 || roomy(row, column) == 0) continue;
        if (!best) last = column + 1 + static_cast<int>(kFirst_m / cell_m_);
        if (!best || clearance_m(row, column) > clearance_m(*best)) best = {column, row};
      }
    }
    if (best) return *best;
    throw UserError(
        fmt::format("nowhere in the map has a Pioneer room to start: {:.2f} m of free "
                    "floor to all sides",
                    kRoom_m));
  }

  /// The heading in which free floor goes on farthest, of those towards the goal line.
  [[nodiscard]] double longest_view(cv::Point from) const {
    constexpr int kTurns = 4;  // to either side, 22.5 deg each
    double best_rad = 0.0;
    int farthest = -1;
    for (int turn = -kTurns; turn <= kTurns; ++turn) {
      const double heading_rad = 0.5 * kPi * turn / kTurns;
      int steps = 0;
      for (;; ++steps) {
        const cv::Point cell(cvRound(from.x + steps * std::cos(heading_rad)),
                             cvRound(from.y + steps * std::sin(heading_rad)));
        if (!cv::Rect({0, 0}, free_.size()).contains(cell) || free_(cell) == 0) break;
      }
      if (steps > farthest) farthest = steps, best_rad = heading_rad;
    }
    return best_rad;
  }

  /// A lamp every few metres, wherever there is floor below it.
  void lamps() {
    World& world = made_.world;
    const double inner_m = world.width_m - 2.0 * kMargin_m;
    const int rows = std::max(1, static_cast<int>(std::lround(inner_m / kLampEvery_m)));
    for (int row = 0; row < rows; ++row) {
      const double left_m = inner_m * ((row + 0.5) / rows - 0.5);
      for (double at_m = 0.0; at_m + kLampEvery_m <= world.length_m; at_m += kLampEvery_m) {
        const cv::Point cell = cell_at({at_m + 0.5 * kLampEvery_m, left_m});
        if (!cv::Rect({0, 0}, free_.size()).contains(cell) || free_(cell) == 0) continue;
        if (!world.lights.empty() && world.lights.back().left_m == left_m &&
            world.lights.back().to_m == at_m) {
          world.lights.back().to_m = at_m + kLampEvery_m;
        } else {
          world.lights.push_back({at_m, at_m + kLampEvery_m, kLampEvery_m, 1.0, left_m});
        }
      }
    }
  }

  double cell_m_;
  cv::Mat1b stands_, free_;
  MapWorld made_;
};

}  // namespace

MapWorld world_from_map(const FloorPicture& picture, const std::string& name,
                        std::optional<Pose2> start) {
  if (cv::countNonZero(picture.free) == 0) throw UserError("nothing in the map is free floor");
  return Builder(picture, name).build(start);
}

}  // namespace striate::simulator
