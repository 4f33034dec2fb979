#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "striate/base/fixed_text.hpp"
#include "striate/base/geometry.hpp"
#include "striate/base/time.hpp"

/// What perception hands on. Robot frame (x forward, y left, from the wheel axle) at the moment of
/// the image; image: u right, v down, pixel centres at integers.
namespace striate::perception {

/// Pixels: not finite, so that no arithmetic makes a measured disparity of it
inline constexpr float kNoMatch = std::numeric_limits<float>::infinity();
/// Metres: farther than everything, so that the nearest of several needs no special case
inline constexpr double kNothing_m = std::numeric_limits<double>::infinity();

/// Dense disparity in the left image's frame, with the camera at this working size.
struct DisparityMap {
  cv::Mat1f disparity_px;  ///< >= 0, sub-pixel; kNoMatch where there is no trusted match
  cv::Mat1f confidence;    ///< 0..1, same size: how likely the disparity is right
  double focal_px = 0.0;
  double centre_u_px = 0.0;
  double centre_v_px = 0.0;
  double baseline_m = 0.0;
  /// So many rows lower the right image showed things than the left one; made good for the match
  double right_lower_px = 0.0;
};

/// What one image column says about the floor plan along its bearing. Between `free_to_m` and
/// `obstacle_m` nothing is known; behind the obstacle the floor is hidden as far as the line of
/// sight over the obstacle's top reaches. See also floor_state(). Unknown is never free.
struct Column {
  double bearing_rad = 0.0;           ///< in the robot frame: the head's pan is in it
  double free_from_m = 0.0;           ///< the floor is seen free from here ...
  double free_to_m = 0.0;             ///< ... to here; empty if not greater than free_from_m
  double free_confidence = 0.0;       ///< 0..1
  double obstacle_m = kNothing_m;     ///< nearest trusted thing that stands in the way
  double obstacle_confidence = 0.0;   ///< 0..1
  double hidden_from_m = kNothing_m;  ///< the floor cannot be seen from here, the obstacle ...
  double hidden_to_m = kNothing_m;    ///< ... to here; kNothing_m with an obstacle: to no end
  double moving = 0.0;  ///< 0..1: share of the obstacle that was free before; see perception/motion
  double hangs_from_m = 0.0;  ///< height of the lowest part of an obstacle that hangs over the
                              ///< floor; 0: it stands on it
};

/// A blob of neighbouring columns at about the same distance.
struct Obstacle {
  double bearing_rad = 0.0;  ///< of its middle
  double distance_m = 0.0;   ///< of its nearest part, from the axle
  double width_m = 0.0;
  double height_m = 0.0;  ///< of its highest part seen, above the floor
  double confidence = 0.0;
  int from_u_px = 0;  ///< columns of the working image that it spans, both inclusive
  int to_u_px = 0;
};

/// Something that moves by itself: neighbouring columns whose obstacle stands where nothing stood
/// a moment ago, seen from wherever the robot was then.
struct MovingThing {
  double bearing_rad = 0.0;  ///< of its middle, now
  double distance_m = 0.0;   ///< from the axle, now
  double width_m = 0.0;
  double confidence = 0.0;      ///< 0..1
  bool velocity_known = false;  ///< else the two fields below are zero
  double forward_m_s = 0.0;     ///< over the floor, in the axes of the robot frame of now
  double left_m_s = 0.0;
  int from_u_px = 0;  ///< columns of the working image, both inclusive
  int to_u_px = 0;
};

/// The corridor as one image shows it.
struct CorridorView {
  bool valid = false;
  double heading_rad = 0.0;     ///< of the corridor's axis, in the robot frame
  double left_m = kNothing_m;   ///< distance of the left wall from the axle; kNothing_m: not seen
  double right_m = kNothing_m;  ///< of the right wall, positive
  double confidence = 0.0;      ///< 0..1
};

/// A salient proto-object.
struct SalientRegion {
  double u_px = 0.0;  ///< centre, working size
  double v_px = 0.0;
  double width_px = 0.0;
  double height_px = 0.0;
  double salience = 0.0;           ///< 0..1, its maximum
  double bearing_rad = 0.0;        ///< robot frame
  double distance_m = kNothing_m;  ///< median of trusted disparity inside; kNothing_m: unknown
};

struct SaliencyMap {
  cv::Mat1f salience;                  ///< 0..1 at the working size
  std::vector<SalientRegion> regions;  ///< most salient first
};

/// 256 bits: bit b is words[b / 64] >> (b % 64) & 1.
struct Descriptor {
  std::array<std::uint64_t, 4> words{};
  friend bool operator==(const Descriptor&, const Descriptor&) = default;
};

struct Keypoint {
  double u_px = 0.0;  ///< sub-pixel, in the image that was handed in
  double v_px = 0.0;
  double wavelength_px = 0.0;  ///< in that same image
  double angle_rad = 0.0;      ///< from +u towards +v; 0 where the descriptor has no orientation
  double response = 0.0;
  Descriptor descriptor;
};

/// A landmark that was found again. Places are in the image that the keypoints came from.
struct Recognition {
  int landmark = 0;    ///< as it was handed in with its views
  int view = 0;        ///< the view that agrees best
  double score = 0.0;  ///< 0..1: how rare by chance; 0.5 is enough, 0.75 is 10^10 times rarer
  double matched_fraction = 0.0;  ///< 0..1 of the view's keypoints
  /// Of them; robust: those that agree on one pose and that no other thing has, too
  int inliers = 0;
  double u_px = 0.0;  ///< where the middle of the view is
  double v_px = 0.0;
  double width_px = 0.0;  ///< of the upright box that encloses it
  double height_px = 0.0;
  double scale = 0.0;              ///< robust: pixels of the image a pixel of the view
  double angle_rad = 0.0;          ///< robust: how far it is turned, from +u towards +v
  double bearing_rad = 0.0;        ///< robot frame; filled in where the camera is known
  double distance_m = kNothing_m;  ///< from the axle; filled in where disparity is known
  double height_m = 0.0;           ///< of its middle above the floor, where the distance is known
};

/// What came of looking where a landmark was expected.
enum class LookResult {
  out_of_view,     ///< not wholly in the image, or too far or too dark to be recognised there
  hidden,          ///< something nearer stands before it
  not_looked_for,  ///< the budget was spent on others
  missed,          ///< it should have been recognised and was not
  found
};

struct ExpectedLook {
  int landmark = 0;  ///< as it was handed in with its views
  LookResult result = LookResult::out_of_view;
};

/// What a stage of a plugin found out (stage.hpp).
struct Figure {
  FixedText<63> name;                                       ///< "STAGE.FIGURE"
  double value = std::numeric_limits<double>::quiet_NaN();  ///< not known
};

/// All that memory wants to know about one image pair.
struct Percept {
  TimePoint stamp;           ///< of the image
  bool valid = false;        ///< false: no image has come yet; everything is empty
  double light_level = 0.0;  ///< mean grey 0..1 after exposure control
  double noise_level = 0.0;  ///< estimated noise of a pixel, grey levels of 255
  /// Height that the line of sight along the image's upper edge gains with each metre: what hangs
  /// higher was out of view. Not known: infinite.
  double top_slope = std::numeric_limits<double>::infinity();
  DisparityMap disparity;
  std::vector<Column> columns;      ///< one per column of the working image, left to right
  std::vector<Obstacle> obstacles;  ///< nearest first
  std::vector<MovingThing> moving;  ///< nearest first; only where motion was asked for
  CorridorView corridor;
  SaliencyMap saliency;
  std::vector<Keypoint> keypoints;
  std::vector<Recognition> recognitions;  ///< most inliers first
  std::vector<ExpectedLook> expected;     ///< of each landmark that memory expected somewhere
  std::vector<Figure> figures;            ///< of the stages of plugins, in their order
};

}  // namespace striate::perception
