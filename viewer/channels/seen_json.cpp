#include "striate/viewer/channels/seen_json.hpp"

#include <algorithm>
#include <cmath>

namespace striate::viewer {
namespace {

/// Of an image's columns, and of its keypoints, by hand: enough to draw them
constexpr std::size_t kColumnsShown = 80;
constexpr std::size_t kKeypointsShown = 400;

/// To two digits behind the point: centimetres, and hundredths of a pixel.
Json hundredths(double value) {
  constexpr double kParts = 100.0;
  return std::isfinite(value) ? Json(std::round(value * kParts) / kParts) : Json(nullptr);
}

Json camera_json(const SeenFacts& seen, const RobotDescription& robot) {
  return {{"height_m", robot.camera_height_m}, {"forward_m", robot.camera_forward_m},
          {"pan_rad", seen.head.pan_rad},      {"tilt_rad", seen.head.tilt_rad},
          {"focal_px", seen.focal_px},         {"centre_u_px", seen.centre_u_px},
          {"centre_v_px", seen.centre_v_px}};
}

Json columns_json(const std::vector<perception::Column>& columns) {
  Json list = Json::array();
  const std::size_t step = std::max<std::size_t>(1, columns.size() / kColumnsShown);
  for (std::size_t u = 0; u < columns.size(); u += step) {
    const perception::Column& one = columns[u];
    constexpr double kTenThousandths = 1e4;
    list.push_back(
        {{"u_px", u},
         {"bearing_rad", std::round(one.bearing_rad * kTenThousandths) / kTenThousandths},
         {"free_from_m", hundredths(one.free_from_m)},
         {"free_to_m", hundredths(one.free_to_m)},
         {"obstacle_m", hundredths(one.obstacle_m)}});
  }
  return list;
}

Json regions_json(const std::vector<perception::SalientRegion>& regions) {
  Json list = Json::array();
  for (const perception::SalientRegion& one : regions) {
    list.push_back({{"u_px", hundredths(one.u_px)},
                    {"v_px", hundredths(one.v_px)},
                    {"width_px", hundredths(one.width_px)},
                    {"height_px", hundredths(one.height_px)},
                    {"salience", hundredths(one.salience)},
                    {"bearing_rad", one.bearing_rad},
                    {"distance_m", hundredths(one.distance_m)}});
  }
  return list;
}

Json keypoints_json(const std::vector<perception::Keypoint>& keypoints, double scale) {
  Json list = Json::array();
  const std::size_t step = 1 + keypoints.size() / kKeypointsShown;
  for (std::size_t k = 0; k < keypoints.size(); k += step) {
    list.push_back(hundredths(keypoints[k].u_px * scale));
    list.push_back(hundredths(keypoints[k].v_px * scale));
    list.push_back(hundredths(keypoints[k].wavelength_px * scale));
  }
  return list;
}

Json landmarks_json(const std::vector<SeenLandmark>& landmarks, double scale) {
  Json list = Json::array();
  for (const SeenLandmark& one : landmarks) {
    list.push_back({{"name", one.name},
                    {"score", hundredths(one.found.score)},
                    {"u_px", hundredths(one.found.u_px * scale)},
                    {"v_px", hundredths(one.found.v_px * scale)},
                    {"width_px", hundredths(one.found.width_px * scale)},
                    {"height_px", hundredths(one.found.height_px * scale)},
                    {"distance_m", hundredths(one.found.distance_m)}});
  }
  return list;
}

Json people_json(const std::vector<perception::MovingThing>& moving) {
  Json list = Json::array();
  for (const perception::MovingThing& one : moving) {
    list.push_back({{"from_u_px", one.from_u_px},
                    {"to_u_px", one.to_u_px},
                    {"bearing_rad", one.bearing_rad},
                    {"distance_m", hundredths(one.distance_m)},
                    {"forward_m_s", one.velocity_known ? hundredths(one.forward_m_s) : Json()},
                    {"left_m_s", one.velocity_known ? hundredths(one.left_m_s) : Json()}});
  }
  return list;
}

}  // namespace

Json seen_json(const CycleFacts& facts, const RobotDescription& robot) {
  const SeenFacts& seen = facts.seen;
  // All in pixels of the smaller image.
  const double scale = seen.image_px.width > 0
                           ? static_cast<double>(seen.working_px.width) / seen.image_px.width
                           : 1.0;
  return {{"stamp_s", to_seconds(facts.percept_stamp)},
          {"width_px", seen.working_px.width},
          {"height_px", seen.working_px.height},
          {"camera", camera_json(seen, robot)},
          {"columns", columns_json(seen.columns)},
          {"regions", regions_json(facts.regions)},
          {"keypoints", keypoints_json(seen.keypoints, scale)},
          {"landmarks", landmarks_json(seen.landmarks, scale)},
          {"people", people_json(facts.moving)}};
}

}  // namespace striate::viewer
