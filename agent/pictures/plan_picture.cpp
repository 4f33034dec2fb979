#include "striate/agent/pictures/plan_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "striate/agent/pictures/plan_strip.hpp"
#include "striate/base/index_within.hpp"
#include "striate/platform/simulator/static_shapes.hpp"

namespace striate::agent::pictures {
namespace {

using simulator::FloorPlan;
constexpr double kStrip_m = 20.0;     // m in a row: 60 m corridors make three
constexpr double kAround_m = 0.45;    // m around the corridor: walls and labels
constexpr int kTitle_px = 46;         // px: a line of text and its gap
constexpr int kLegend_px = 40;        // px: a line of text and its gap
constexpr int kLeastWidth_px = 1110;  // the legend needs it
const cv::Scalar kObstacle(90, 125, 170);
const cv::Scalar kDrop(40, 40, 50);           // a hole in the floor
const cv::Scalar kFloorPatch(205, 195, 175);  // carpet, water
const cv::Scalar kPeople(190, 120, 60);
const cv::Scalar kNear(0, 140, 255);

/// 0.05 m/s dark blue .. 0.6 m/s green-yellow.
cv::Scalar colour_of_speed(double speed_m_s) {
  const cv::Mat1b value(1, 1,
                        cv::saturate_cast<uchar>(255.0 * std::clamp(speed_m_s / 0.6, 0., 1.)));
  cv::Mat3b colour;
  cv::applyColorMap(value, colour, cv::COLORMAP_VIRIDIS);
  return {double(colour(0)[0]), double(colour(0)[1]), double(colour(0)[2])};
}

void draw_world(Strip& strip, const simulator::World& world, const FloorPlan& plan,
                const simulator::ImageSource* light) {
  strip.floor(plan, light);
  for (const simulator::FloorPatch& patch : world.floor_patches) {
    Pose2 middle = plan.at(patch.at.x_m, patch.at.y_m);
    middle.heading_rad += patch.turn_rad;
    strip.shape(simulator::rectangle(middle, patch.size_x_m, patch.size_y_m), kFloorPatch);
    strip.text({middle.x_m, middle.y_m}, patch.material, kPlanInk);
  }
  for (const simulator::StaticShape& thing : simulator::drops(world, plan)) {
    strip.shape(thing.shape, kDrop);
    strip.text(thing.middle, thing.name + " down", kPlanInk);
  }
  for (const simulator::StaticShape& thing : simulator::solid_shapes(world, plan)) {
    strip.shape(thing.shape, kObstacle);
    strip.text(thing.middle, thing.name, kPlanInk);
  }
  for (const double along_m : {world.start.x_m, world.goal_beyond_m}) {
    const Pose2 left = plan.at(along_m, 1.2);
    const Pose2 right = plan.at(along_m, -1.2);
    strip.line({left.x_m, left.y_m}, {right.x_m, right.y_m}, cv::Scalar(80, 160, 60), 2);
    strip.text({left.x_m, left.y_m}, along_m == world.goal_beyond_m ? "goal" : "start",
               cv::Scalar(60, 120, 40));
  }
}

void draw_people(Strip& strip, const simulator::Judge& judge) {
  for (const simulator::PeopleAt& moment : judge.people()) {
    for (const Pose2& person : moment.people) {
      strip.dot({person.x_m, person.y_m}, 2, kPeople, cv::FILLED);
    }
  }
}

void draw_run(Strip& strip, const simulator::Judge& judge, const FloorPlan& plan) {
  const auto& path = judge.path();
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Point2 from{path[i - 1].pose.x_m, path[i - 1].pose.y_m};
    const Point2 to{path[i].pose.x_m, path[i].pose.y_m};
    const double time_s = std::max(1e-3, path[i].time_s - path[i - 1].time_s);
    const double speed_m_s = std::hypot(to.x_m - from.x_m, to.y_m - from.y_m) / time_s;
    strip.line(from, to, colour_of_speed(speed_m_s), 3);
  }
  for (const simulator::NearMiss& miss : judge.near_misses()) {
    const Pose2 at = plan.at(miss.along_m, miss.left_m);
    strip.dot({at.x_m, at.y_m}, 14, kNear, 2);
    strip.text({at.x_m, at.y_m}, fmt::format("{:.0f} cm", 100.0 * miss.clearance_m), kNear);
  }
  for (const simulator::Collision& hit : judge.collisions()) {
    const Pose2 at = plan.at(hit.along_m, hit.left_m);
    strip.cross({at.x_m, at.y_m});
    strip.text({at.x_m, at.y_m}, hit.hit, kHit, 0.5);
  }
}

void draw_legend(cv::Mat3b row) {
  const auto put = [&](int u, const std::string& words) {
    cv::putText(row, words, {u, 26}, cv::FONT_HERSHEY_SIMPLEX, 0.46, kPlanInk, 1, cv::LINE_AA);
  };
  for (int i = 0; i < 120; ++i) {
    cv::line(row, {16 + i, 16}, {16 + i, 26}, colour_of_speed(0.6 * i / 120.0), 1);
  }
  put(144, "0 to 0.6 m/s");
  cv::circle(row, {290, 21}, 3, kPeople, cv::FILLED, cv::LINE_AA);
  put(302, "people, each half second");
  cv::circle(row, {530, 21}, 10, kNear, 2, cv::LINE_AA);
  put(548, "passed nearer than 10 cm");
  cv::line(row, {772, 13}, {788, 29}, kHit, 3, cv::LINE_AA);
  cv::line(row, {772, 29}, {788, 13}, kHit, 3, cv::LINE_AA);
  put(798, "touched");
  put(890, "floor: as light as it is there");
}

}  // namespace

cv::Mat3b draw_plan(const simulator::World& world, const FloorPlan& plan,
                    const simulator::Judge& judge, const simulator::ImageSource* light,
                    const std::string& title) {
  const Bounds all = bounds_of(plan, -1e9, 1e9);
  const double length_m = all.high_x_m - all.low_x_m;
  const int strips = std::max(1, static_cast<int>(std::ceil(length_m / kStrip_m - 1e-6)));
  const double strip_m = std::min(length_m, kStrip_m);
  const int width = std::max(kLeastWidth_px, static_cast<int>((strip_m + 2 * kAround_m) * kScale));
  cv::Mat3b image(kTitle_px, width, cv::Vec3b(250, 250, 250));
  cv::putText(image, title, {16, 32}, cv::FONT_HERSHEY_SIMPLEX, 0.62, kPlanInk, 1, cv::LINE_AA);
  for (int i = 0; i < strips; ++i) {
    const double from_x_m = all.low_x_m + i * kStrip_m - kAround_m;
    const Bounds box = bounds_of(plan, from_x_m, from_x_m + strip_m + 2 * kAround_m);
    const double height_m = box.high_y_m - box.low_y_m + 2 * kAround_m;
    cv::Mat3b area(static_cast<int>(height_m * kScale), width, cv::Vec3b(250, 250, 250));
    Strip strip(area, from_x_m, box.high_y_m + kAround_m);
    draw_world(strip, world, plan, light);
    draw_people(strip, judge);
    draw_run(strip, judge, plan);
    strip.draw_words();
    image.push_back(area);
  }
  image.push_back(cv::Mat3b(kLegend_px, width, cv::Vec3b(250, 250, 250)));
  draw_legend(image.rowRange(image.rows - kLegend_px, image.rows));
  return image;
}

}  // namespace striate::agent::pictures
