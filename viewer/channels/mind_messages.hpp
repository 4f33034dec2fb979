#pragma once

#include "striate/viewer/channels/cycle_facts.hpp"
#include "striate/viewer/messages/navigation_messages.hpp"
#include "striate/viewer/messages/report_messages.hpp"
#include "striate/viewer/messages/sensor_messages.hpp"

/// What the robot saw and remembers, as messages of ROS 2.
namespace striate::viewer {

/// Below `min_disparity` where nothing is known, as stereo_msgs says it.
void write_disparity(const CycleFacts& facts, msgs::DisparityImage& message);
/// Grey, 0 to 255.
void write_saliency(const CycleFacts& facts, msgs::Image& message);
/// Boxes in the base's frame of the image's moment: what stands, and in another colour what moves.
[[nodiscard]] msgs::MarkerArray obstacles_of(const CycleFacts& facts);

void write_grid(const FloorGrid& grid, const msgs::Header& header, msgs::OccupancyGrid& message);
[[nodiscard]] msgs::Path trajectory_of(const CycleFacts& facts);
/// Of landmarks whose place is known: a ball as wide as its standard deviation, and its name.
[[nodiscard]] msgs::MarkerArray landmarks_of(const CycleFacts& facts);
/// The stretches from landmark to landmark that were driven, on the map.
[[nodiscard]] msgs::MarkerArray routes_of(const CycleFacts& facts);
/// On the map. @pre `facts.on_map`
[[nodiscard]] msgs::PoseWithCovarianceStamped pose_of(const CycleFacts& facts);

}  // namespace striate::viewer
