#include "striate/agent/teaching/live_teacher.hpp"

#include <algorithm>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "striate/agent/teaching/image_view.hpp"
#include "striate/behaviours/teach.hpp"
#include "striate/memory/long_term/view_codec.hpp"

namespace striate::agent {
namespace {

constexpr int kViewJpegQuality = 90;  // of 100: so mild that no blocks are seen (ours)

}  // namespace

memory::StoredView stored_view(const cv::Mat3b& left, const perception::ThingRegion& thing,
                               const memory::LongTermSettings& settings) {
  cv::Mat1b grey;
  cv::cvtColor(left, grey, cv::COLOR_BGR2GRAY);
  const perception::LandmarkView seen = perception::view_of_thing(grey, thing, keypoints_to_learn);
  memory::StoredView view;
  view.width_px = seen.width_px;
  view.height_px = seen.height_px;
  view.range_m = thing.distance_m;
  view.bearing_rad = thing.bearing_rad;
  // The strongest come first.
  const auto most = static_cast<std::size_t>(settings.most_keypoints);
  for (std::size_t k = 0; k < std::min(most, seen.keypoints.size()); ++k) {
    const perception::ViewKeypoint& point = seen.keypoints[k];
    view.keypoints.push_back({point.x_px, point.y_px, point.size_px, point.angle_rad});
    view.descriptors.push_back(memory::stored(seen.descriptors[k]));
  }
  cv::imencode(".jpg", left(perception::full_size_box(thing, left.size())), view.image,
               {cv::IMWRITE_JPEG_QUALITY, kViewJpegQuality});
  return view;
}

bool LiveTeacher::take(const CycleTrace& trace) {
  return trace.wish.why.view() == behaviours::Teach::kTakesView && look(trace);
}

bool LiveTeacher::look(const CycleTrace& trace) {
  if (!trace.percept.valid) return false;
  const StereoFrame& image = trace.senses.stereo;
  const perception::ViewGeometry geometry(trace.percept.disparity, image.head, robot_);
  const auto thing = perception::find_thing(trace.percept, geometry, image.head.pan_rad);
  if (!thing) {
    ++in_vain_;
    return false;
  }
  views_.push_back(stored_view(image.left, *thing, settings_));
  return true;
}

}  // namespace striate::agent
