#include "striate/app/frame_summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "striate/base/geometry.hpp"

namespace striate::app {
namespace {

using nlohmann::ordered_json;

constexpr double kAhead_rad = 0.1745;  // 10 degrees: the robot's own width at 2 m (ours)

double known_share(const cv::Mat1f& disparity_px) {
  std::size_t known = 0;
  for (const float d : disparity_px) known += std::isfinite(d) ? 1 : 0;
  return static_cast<double>(known) / static_cast<double>(disparity_px.total());
}

void add_floor(const perception::Percept& percept, FrameSummary& summary) {
  std::size_t free = 0;
  for (const perception::Column& column : percept.columns) {
    const bool is_free = column.free_to_m > column.free_from_m;
    free += is_free ? 1 : 0;
    if (std::abs(column.bearing_rad) > kAhead_rad) continue;
    const double to_m = is_free ? column.free_to_m : 0.0;
    summary.free_ahead = std::min(summary.free_ahead.value_or(to_m), to_m);
  }
  if (percept.columns.empty()) return;
  summary.free_share = static_cast<double>(free) / static_cast<double>(percept.columns.size());
}

ordered_json rounded(const std::optional<double>& value) {
  if (!value || !std::isfinite(*value)) return nullptr;
  return std::round(*value * 1e4) / 1e4;
}

std::string side_of(double bearing_deg) {
  return fmt::format("{:.0f} deg {}", std::abs(bearing_deg), bearing_deg < 0.0 ? "right" : "left");
}

}  // namespace

FrameSummary summary_of(const JudgedFrame& judged) {
  const perception::Percept& percept = judged.percept;
  FrameSummary summary;
  summary.unit = judged.report.unit;
  summary.warned = !judged.report.warnings.empty();
  if (!percept.disparity.disparity_px.empty()) {
    summary.dense = known_share(percept.disparity.disparity_px);
  }
  if (!percept.obstacles.empty()) {
    summary.nearest = percept.obstacles.front().distance_m;
    summary.nearest_bearing_deg = degrees(percept.obstacles.front().bearing_rad);
  }
  if (judged.report.floor_known) add_floor(percept, summary);
  summary.salient = percept.saliency.regions.size();
  if (summary.salient > 0) {
    const perception::SalientRegion& most = percept.saliency.regions.front();
    summary.most_salient_bearing_deg = degrees(most.bearing_rad);
    if (judged.report.unit == "m" && std::isfinite(most.distance_m)) {
      summary.most_salient = most.distance_m;
    }
  }
  return summary;
}

std::string text_of(const FrameSummary& s) {
  const std::string unit = s.unit == "m" ? "m" : s.unit;
  std::string text = fmt::format("{:>6}", s.number);
  if (s.since_s) text += fmt::format(" {:8.2f} s", *s.since_s);
  text += s.dense ? fmt::format("  dense {:3.0f} %", 100.0 * *s.dense) : "  one eye";
  if (s.dense) {
    text += s.nearest ? fmt::format("  nearest {:5.2f} {} {}", *s.nearest, unit,
                                    side_of(s.nearest_bearing_deg))
                      : "  nothing near";
  }
  if (s.free_share) {
    text += fmt::format("  free floor in {:.0f} % of the view, ahead {:.1f} {}",
                        100.0 * *s.free_share, s.free_ahead.value_or(0.0), unit);
  }
  if (s.salient > 0) {
    text += fmt::format("  {} salient, most {}", s.salient, side_of(s.most_salient_bearing_deg));
    if (s.most_salient) text += fmt::format(" at {:.1f} m", *s.most_salient);
  }
  if (s.warned) text += "  (!)";
  return text + "\n";
}

ordered_json json_of(const FrameSummary& s) {
  return {
      {"frame", s.number},
      {"name", s.name},
      {"time_s", rounded(s.since_s)},
      {"unit", s.unit},
      {"dense", rounded(s.dense)},
      {"nearest", rounded(s.nearest)},
      {"nearest_bearing_deg", s.nearest ? rounded(s.nearest_bearing_deg) : nullptr},
      {"free_share", rounded(s.free_share)},
      {"free_ahead", rounded(s.free_ahead)},
      {"salient_regions", s.salient},
      {"most_salient_bearing_deg", s.salient > 0 ? rounded(s.most_salient_bearing_deg) : nullptr},
      {"most_salient_distance", rounded(s.most_salient)},
      {"warned", s.warned}};
}

void SequenceSummary::add(const FrameSummary& frame) {
  ++frames_;
  unit_ = frame.unit;
  warned_ += frame.warned ? 1 : 0;
  salient_sum_ += static_cast<double>(frame.salient);
  if (frame.dense) {
    ++with_two_eyes_;
    dense_sum_ += *frame.dense;
    least_dense_ = std::min(least_dense_, *frame.dense);
  }
  if (frame.free_share) {
    ++with_floor_;
    free_sum_ += *frame.free_share;
  }
  if (frame.nearest && (!nearest_ || *frame.nearest < *nearest_)) {
    nearest_ = frame.nearest;
    nearest_frame_ = frame.number;
  }
}

std::string SequenceSummary::text() const {
  if (frames_ == 0) return "no frame was seen\n";
  const auto mean = [](double sum, std::uint64_t count) {
    return sum / static_cast<double>(count);
  };
  std::string text = fmt::format("{} frame{}", frames_, frames_ == 1 ? "" : "s");
  if (with_two_eyes_ > 0) {
    text += fmt::format("; dense {:.0f} % (least {:.0f} %)",
                        100.0 * mean(dense_sum_, with_two_eyes_), 100.0 * least_dense_);
  }
  if (nearest_) {
    text +=
        fmt::format("; nearest obstacle {:.2f} {} in frame {}", *nearest_, unit_, nearest_frame_);
  }
  if (with_floor_ > 0) {
    text +=
        fmt::format("; free floor in {:.0f} % of the view", 100.0 * mean(free_sum_, with_floor_));
  }
  text += fmt::format("; {:.1f} salient regions a frame", mean(salient_sum_, frames_));
  if (warned_ > 0) {
    text += fmt::format("; {} frames (!) do not look like pairs of rectified eyes", warned_);
  }
  return text + "\n";
}

ordered_json SequenceSummary::json() const {
  const auto mean = [](double sum, std::uint64_t count) -> std::optional<double> {
    if (count == 0) return {};
    return sum / static_cast<double>(count);
  };
  return {{"frames", frames_},
          {"unit", unit_},
          {"dense", rounded(mean(dense_sum_, with_two_eyes_))},
          {"least_dense", with_two_eyes_ > 0 ? rounded(least_dense_) : nullptr},
          {"nearest", rounded(nearest_)},
          {"nearest_frame", nearest_ ? ordered_json(nearest_frame_) : nullptr},
          {"free_share", rounded(mean(free_sum_, with_floor_))},
          {"salient_regions", rounded(mean(salient_sum_, frames_))},
          {"frames_warned", warned_}};
}

}  // namespace striate::app
