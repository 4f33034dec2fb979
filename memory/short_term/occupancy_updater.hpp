#pragma once

#include <vector>

#include "striate/config/settings.hpp"
#include "striate/memory/short_term/local_grid.hpp"
#include "striate/perception/percept.hpp"

namespace striate::memory {

/// How one look becomes evidence. Ours: the paper gives no map.
///
/// By hand (README.md, "Where the numbers come from"), in steps that make whole looks: see
/// LocalGrid.
struct OccupancySettings {
  double disparity_error_px = 0.35;  ///< of a trusted match, one sigma
  double far_m = 5.5;                ///< beyond this a look says nothing: a range errs by 0.43 m
  double near_m = 1.0;               ///< within this one look is enough
  double occupied_gain = 0.9;        ///< log-odds of a full look at something: two make it stand
  double free_gain = 0.55;           ///< log-odds of a full look at bare floor: one makes it free
  double near_boost = 4.0;           ///< times the gain within near_m: one look makes it sure
  double lone_column_weight = 0.2;   ///< of a column that no neighbour agrees with: seven looks
};

template <class V>
void visit(V& v, OccupancySettings& s) {
  using config::Unit;
  v.number("disparity_error", s.disparity_error_px, Unit::pixels, {0.05, 4},
           "error of a trusted match, one sigma");
  v.retired("disparity_metre",
            "the camera says it: focal length times baseline comes with each image");
  v.number("far", s.far_m, Unit::length, {1, 6}, "beyond this a look says nothing");
  v.number("near", s.near_m, Unit::length, {0, 3}, "within this one look is enough to block");
  v.number("occupied_gain", s.occupied_gain, Unit::none, {0.05, 3},
           "log-odds of one full look at something");
  v.number("free_gain", s.free_gain, Unit::none, {0.05, 3},
           "log-odds of one full look at bare floor");
  v.number("near_boost", s.near_boost, Unit::none, {1, 10}, "times the gain within 'near'");
  v.number("lone_column_weight", s.lone_column_weight, Unit::fraction, {0, 1},
           "weight of a column that no neighbour agrees with");
}

/// Writes the columns of one image into the grid. All columns of a look are gathered first, and
/// a cell gains or loses at most one look's worth, however many columns pass through it: columns
/// of one image err together, so they are no independent witnesses.
class OccupancyUpdater {
 public:
  OccupancyUpdater(const OccupancySettings& settings, double camera_height_m);

  /// `pose` is the robot's in the odometry frame at the moment of the image.
  void write(const perception::Percept& percept, const Pose2& pose, LocalGrid& grid);

 private:
  struct Mass {
    bool touched = false;
    float occupied = 0.0F;
    float free = 0.0F;
    float past = 0.0F;          ///< columns that saw past, above the floor ...
    float past_above_m = 0.0F;  ///< ... all that is higher than this
    float height_m = 0.0F;
    float hangs_from_m = 0.0F;  ///< 0: some column met something that stands, or none met anything
  };
  struct ViewOfImage {
    const Pose2& pose;
    TimePoint stamp;
    double column_rad;
    double top_slope;  ///< Percept::top_slope
  };
  void measure_heights(const perception::Percept& percept);
  void gather_free(const perception::Column& column, const ViewOfImage& look);
  void gather_past(const perception::Column& column, const ViewOfImage& look);
  void gather_occupied(const perception::Column& column, double support, double height_m,
                       const ViewOfImage& look);
  [[nodiscard]] bool floor_says_nothing(GridCell cell, double distance_m, const ViewOfImage& look,
                                        const LocalGrid& grid) const;
  [[nodiscard]] static bool was_taken_for_floor(GridCell cell, const Mass& mass,
                                                const LocalGrid& grid);
  Mass& touch(GridCell cell);
  void settle(GridCell cell, const Mass& mass, const ViewOfImage& look, LocalGrid& grid) const;
  void settle_past(GridCell cell, const Mass& mass, double share, const ViewOfImage& look,
                   LocalGrid& grid) const;
  [[nodiscard]] double support_of(const std::vector<perception::Column>& columns,
                                  std::size_t i) const;
  [[nodiscard]] double range_error_m(double distance_m) const;

  OccupancySettings settings_;
  double camera_height_m_;
  double disparity_metre_px_ = 0.0;  // focal length x baseline: Z = this / disparity
  std::vector<float> heights_m_;     // of what each column met
  std::vector<Mass> masses_;
  std::vector<GridCell> touched_;
};

}  // namespace striate::memory
