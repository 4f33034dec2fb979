#include "striate/agent/recall/known_things.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "striate/agent/teaching/image_view.hpp"
#include "striate/base/plain_text.hpp"
#include "striate/base/user_error.hpp"

namespace striate::agent {
namespace {

using perception::Keypoint;
using perception::LandmarkView;
using perception::Pose;

constexpr int kNoPicture_px = 16;  // px: a smaller side shows nothing (image_view.cpp)

int bits_apart(const perception::Descriptor& a, const perception::Descriptor& b) {
  int bits = 0;
  for (std::size_t k = 0; k < a.words.size(); ++k) bits += std::popcount(a.words[k] ^ b.words[k]);
  return bits;
}

/// The similarity that a recognition tells: its middle, scale and turn.
Pose similarity_of(const perception::Recognition& found, const LandmarkView& view) {
  const double c = found.scale * std::cos(found.angle_rad);
  const double s = found.scale * std::sin(found.angle_rad);
  Pose pose{c, -s, 0.0, s, c, 0.0};
  const double u = 0.5 * (view.width_px - 1.0);
  const double v = 0.5 * (view.height_px - 1.0);
  pose.c = found.u_px - pose.u_of(u, v);
  pose.f = found.v_px - pose.v_of(u, v);
  return pose;
}

/// Keypoints of the picture that are like one of the view, and where the pose puts it.
std::vector<perception::PlacePair> agreeing(const LandmarkView& view,
                                            const std::vector<Keypoint>& points, const Pose& pose,
                                            double tolerance_px, int limit_bits) {
  std::vector<perception::PlacePair> pairs;
  for (std::size_t k = 0; k < view.keypoints.size(); ++k) {
    const double u = pose.u_of(view.keypoints[k].x_px, view.keypoints[k].y_px);
    const double v = pose.v_of(view.keypoints[k].x_px, view.keypoints[k].y_px);
    const Keypoint* nearest = nullptr;
    int fewest = limit_bits;
    for (const Keypoint& point : points) {
      if (std::hypot(point.u_px - u, point.v_px - v) > tolerance_px) continue;
      const int bits = bits_apart(point.descriptor, view.descriptors[k]);
      if (bits >= fewest) continue;
      fewest = bits;
      nearest = &point;
    }
    if (nearest == nullptr) continue;
    pairs.push_back({{view.keypoints[k].x_px, view.keypoints[k].y_px, view.keypoints[k].size_px,
                      view.keypoints[k].angle_rad},
                     perception::place_of(*nearest),
                     static_cast<int>(k)});
  }
  return pairs;
}

/// A recognition tells scale and turn; what is seen aslant is drawn out, too. Fitted twice, the
/// second time to what agrees closely.
Pose refined(const perception::Recognition& found, const LandmarkView& view,
             const std::vector<Keypoint>& points, const perception::RecognitionSettings& settings) {
  Pose pose = similarity_of(found, view);
  const double side_px = 0.5 * (view.width_px + view.height_px) * found.scale;
  for (const double tolerance : {settings.vote_tolerance, settings.fit_tolerance}) {
    const auto pairs = agreeing(view, points, pose, tolerance * side_px, settings.limit_bits);
    if (pairs.size() < static_cast<std::size_t>(settings.least_inliers)) break;
    const Pose fitted = perception::fit_affine(pairs);
    if (!(fitted.stretch() <= settings.most_stretch) || !(fitted.scale() > 0.5 * pose.scale()) ||
        !(fitted.scale() < 2.0 * pose.scale())) {
      break;
    }
    pose = fitted;
  }
  return pose;
}

}  // namespace

KnownThings::KnownThings(const memory::LandmarkKnowledge& knowledge,
                         const perception::RecognitionSettings& settings,
                         const std::vector<std::string>& only)
    : settings_(settings), recogniser_(settings) {
  for (const std::string& name : only) {
    const bool known = std::ranges::any_of(
        knowledge.landmarks, [&](const memory::LandmarkModel& m) { return m.record.name == name; });
    if (known) continue;
    std::string there;
    for (const memory::LandmarkModel& model : knowledge.landmarks) {
      if (!there.empty()) there += ", ";
      there += plain_text(model.record.name);
    }
    throw UserError(fmt::format("no landmark in the memory is called '{}'; there are: {}",
                                plain_text(name), there));
  }
  for (const memory::LandmarkModel& model : knowledge.landmarks) {
    if (!only.empty() && std::ranges::find(only, model.record.name) == only.end()) continue;
    const int landmark = static_cast<int>(names_.size());
    names_.push_back(model.record.name);
    int number = 0;
    for (const LandmarkView& view : model.views) {
      recogniser_.add(landmark, view);
      views_.push_back({landmark, number++, view});
    }
  }
}

std::vector<KnownThing> KnownThings::find(const cv::Mat3b& picture) {
  std::vector<KnownThing> things;
  const cv::Mat3b small = picture_to_learn(picture);
  if (std::min(small.cols, small.rows) < kNoPicture_px) return things;
  cv::Mat1b grey;
  cv::cvtColor(small, grey, cv::COLOR_BGR2GRAY);
  const std::vector<Keypoint> points = keypoints_to_learn(grey);
  const double larger_u = static_cast<double>(picture.cols) / small.cols;
  const double larger_v = static_cast<double>(picture.rows) / small.rows;
  for (const perception::Recognition& found : recogniser_.recognise(points)) {
    const View& view = views_[static_cast<std::size_t>(found.view)];
    const Pose pose = settings_.mode == perception::RecognitionMode::robust
                          ? refined(found, view.view, points, settings_)
                          : Pose{};
    KnownThing thing{names_[static_cast<std::size_t>(found.landmark)],
                     view.number,
                     found.inliers,
                     found.score,
                     found.matched_fraction,
                     pose.scale() * larger_u,
                     pose.angle_rad(),
                     {}};
    const double w = view.view.width_px - 1.0;
    const double h = view.view.height_px - 1.0;
    const cv::Point2d corners[4] = {{0.0, 0.0}, {w, 0.0}, {w, h}, {0.0, h}};
    for (std::size_t k = 0; k < 4; ++k) {
      // Pixel centres are at integers.
      thing.quad[k] = {(pose.u_of(corners[k].x, corners[k].y) + 0.5) * larger_u - 0.5,
                       (pose.v_of(corners[k].x, corners[k].y) + 0.5) * larger_v - 0.5};
    }
    things.push_back(thing);
  }
  return things;
}

}  // namespace striate::agent
