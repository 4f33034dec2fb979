#include "striate/perception/visual_odometry/keyframe_window.hpp"

#include <algorithm>

#include "striate/perception/visual_odometry/bundle.hpp"

namespace striate::perception {
namespace {

constexpr int kBundleSteps = 6;           // steps; usually three are enough
constexpr double kFirstDamping = 1e-4;    // of the diagonal, after Marquardt (by hand)
constexpr double kLittleGain = 1e-4;      // of the cost: then it is as good as it gets (by hand)
constexpr std::size_t kMostTracks = 400;  // points that are refined; more cost time alone (by hand)

/// Points that two keyframes or more have seen; those seen by most first, then the older.
std::vector<std::pair<std::int64_t, int>> shared_tracks(const std::deque<WindowKeyframe>& frames) {
  std::map<std::int64_t, int> counts;
  for (const WindowKeyframe& frame : frames) {
    for (const TrackSight& sight : frame.sights) ++counts[sight.track];
  }
  std::vector<std::pair<std::int64_t, int>> shared;
  for (const auto& [track, count] : counts) {
    if (count > 1) shared.emplace_back(track, count);
  }
  std::ranges::stable_sort(shared,
                           [](const auto& a, const auto& b) { return a.second > b.second; });
  if (shared.size() > kMostTracks) shared.resize(kMostTracks);
  return shared;
}

/// Its sights, and its place by the one that saw it nearest.
void add_track(const std::deque<WindowKeyframe>& frames, std::int64_t track, Bundle& bundle) {
  const int point = static_cast<int>(bundle.points_m.size());
  double nearest_px = 0.0;
  cv::Vec3d place;
  for (std::size_t k = 0; k < frames.size(); ++k) {
    const auto at = std::ranges::lower_bound(frames[k].sights, track, {}, &TrackSight::track);
    if (at == frames[k].sights.end() || at->track != track) continue;
    bundle.sights.push_back({static_cast<int>(k), point, at->sight, at->noise_px});
    if (at->sight[2] <= nearest_px) continue;
    nearest_px = at->sight[2];
    place = inverse(frames[k].camera_from_world) * point_of(bundle.eyes, at->sight);
  }
  bundle.points_m.push_back(place);
}

void settle(Bundle& bundle) {
  double damping = kFirstDamping;
  double cost = bundle_cost(bundle);
  for (int step = 0; step < kBundleSteps; ++step) {
    Bundle moved;
    if (!bundle_step(bundle, damping, moved)) return;
    const double next = bundle_cost(moved);
    if (!(next < cost)) {
      damping *= 100.0;
      continue;
    }
    const bool enough = cost - next < kLittleGain * cost;
    bundle = std::move(moved);
    cost = next;
    damping *= 0.1;
    if (enough) return;
  }
}

}  // namespace

void KeyframeWindow::add(WindowKeyframe frame) {
  frames_.push_back(std::move(frame));
  while (static_cast<int>(frames_.size()) > most_) frames_.pop_front();
}

void KeyframeWindow::refine(const StereoEyes& eyes, double noise_px) {
  places_.clear();
  if (frames_.size() < 2) return;
  Bundle bundle;
  bundle.eyes = eyes;
  bundle.noise_px = noise_px;
  for (const WindowKeyframe& frame : frames_) {
    bundle.camera_from_world.push_back(frame.camera_from_world);
  }
  const auto tracks = shared_tracks(frames_);
  for (const auto& [track, count] : tracks) add_track(frames_, track, bundle);
  settle(bundle);
  for (std::size_t k = 0; k < frames_.size(); ++k) {
    frames_[k].camera_from_world = bundle.camera_from_world[k];
  }
  for (std::size_t k = 0; k < tracks.size(); ++k) {
    places_[tracks[k].first] = {bundle.points_m[k], tracks[k].second};
  }
}

}  // namespace striate::perception
