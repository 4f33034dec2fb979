#include "platform/simulator/camera_link.hpp"

#include <utility>

namespace striate::simulator {
namespace {

constexpr double kAlmostS = 1e-9;  // sums of 10 ms are not exact: a nanosecond is there
/// The camera runs on its own clock: its pictures fall between the base's cycles.
constexpr double kFirstExposureS = 0.010;

}  // namespace

CameraLink::CameraLink(std::uint64_t seed, const SensorSettings& sensors,
                       const FaultSettings& faults)
    : random_(seed, Purpose::picture_loss), sensors_(sensors), faults_(faults) {}

bool CameraLink::due(double now_s) {
  const double next = kFirstExposureS + static_cast<double>(exposures_) * sensors_.camera_period_s;
  if (now_s + kAlmostS < next) return false;
  frame_ = exposures_++;
  return !lost(now_s);
}

bool CameraLink::lost(double now_s) const {
  const bool stopped = faults_.camera_stops_at_s > 0.0 && now_s >= faults_.camera_stops_at_s;
  const bool returned = faults_.camera_returns_at_s > 0.0 && now_s >= faults_.camera_returns_at_s;
  return (stopped && !returned) || random_.uniform(frame_) < faults_.picture_loss;
}

void CameraLink::take(StereoFrame picture, double now_s) {
  picture.stamp = TimePoint(from_seconds(now_s));
  under_way_.push_back({now_s + sensors_.camera_latency_s, std::move(picture)});
}

void CameraLink::deliver(double now_s, StereoFrame& newest) {
  while (!under_way_.empty() && under_way_.front().arrives_s <= now_s + kAlmostS) {
    newest = std::move(under_way_.front().picture);
    under_way_.pop_front();
  }
}

}  // namespace striate::simulator
