#include "app/teaching/live_teacher.hpp"

#include <algorithm>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "app/memory/picture_view.hpp"
#include "behaviours/teach.hpp"
#include "memory/long_term/view_codec.hpp"

namespace striate {
namespace {

constexpr int kJpegQuality = 90;  // of 100: so mild that no blocks are seen (ours)

}  // namespace

StoredView stored_view(const cv::Mat3b& left, const ThingRegion& thing,
                       const LongTermSettings& settings) {
  cv::Mat1b grey;
  cv::cvtColor(left, grey, cv::COLOR_BGR2GRAY);
  const LandmarkView seen = view_of_thing(grey, thing, keypoints_to_learn);
  StoredView view;
  view.width_px = seen.width_px;
  view.height_px = seen.height_px;
  view.range_m = thing.distance_m;
  view.bearing_rad = thing.bearing_rad;
  // The strongest come first.
  const auto most = static_cast<std::size_t>(settings.most_keypoints);
  for (std::size_t k = 0; k < std::min(most, seen.keypoints.size()); ++k) {
    const ViewKeypoint& point = seen.keypoints[k];
    view.keypoints.push_back({point.x_px, point.y_px, point.size_px, point.angle_rad});
    view.descriptors.push_back(stored(seen.descriptors[k]));
  }
  cv::imencode(".jpg", left(full_size_box(thing, left.size())), view.picture,
               {cv::IMWRITE_JPEG_QUALITY, kJpegQuality});
  return view;
}

bool LiveTeacher::take(const CycleTrace& trace) {
  return trace.wish.why.view() == Teach::kTakesView && look(trace);
}

bool LiveTeacher::look(const CycleTrace& trace) {
  if (!trace.percept.valid) return false;
  const StereoFrame& picture = trace.senses.stereo;
  const ViewGeometry geometry(trace.percept.disparity, picture.head, robot_);
  const auto thing = find_thing(trace.percept, geometry, picture.head.pan_rad);
  if (!thing) {
    ++in_vain_;
    return false;
  }
  views_.push_back(stored_view(picture.left, *thing, settings_));
  return true;
}

}  // namespace striate
