#include "striate/platform/simulator/camera_link.hpp"

#include <utility>

namespace striate::simulator {
namespace {

constexpr double kAlmost_s = 1e-9;  // sums of 10 ms are not exact: a nanosecond is there
/// The camera runs on its own clock: its images fall between the base's cycles.
constexpr double kFirstExposure_s = 0.010;

}  // namespace

CameraLink::CameraLink(std::uint64_t seed, const SensorSettings& sensors,
                       const FaultSettings& faults)
    : random_(seed, Purpose::image_loss), sensors_(sensors), faults_(faults) {}

bool CameraLink::due(double now_s) {
  const double next = kFirstExposure_s + static_cast<double>(exposures_) * sensors_.camera_period_s;
  if (now_s + kAlmost_s < next) return false;
  frame_ = exposures_++;
  return !lost(now_s);
}

bool CameraLink::lost(double now_s) const {
  const bool stopped = faults_.camera_stops_at_s > 0.0 && now_s >= faults_.camera_stops_at_s;
  const bool returned = faults_.camera_returns_at_s > 0.0 && now_s >= faults_.camera_returns_at_s;
  return (stopped && !returned) || random_.uniform(frame_) < faults_.image_loss;
}

void CameraLink::take(StereoFrame image, double now_s) {
  image.stamp = TimePoint(from_seconds(now_s));
  under_way_.push_back({now_s + sensors_.camera_latency_s, std::move(image)});
}

void CameraLink::deliver(double now_s, StereoFrame& newest) {
  while (!under_way_.empty() && under_way_.front().arrives_s <= now_s + kAlmost_s) {
    newest = std::move(under_way_.front().image);
    under_way_.pop_front();
  }
}

}  // namespace striate::simulator
