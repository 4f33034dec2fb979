#include <fmt/format.h>

#include <algorithm>

#include "striate/platform/pioneer/firmware/urg_device.hpp"

/// States and replies are those of Hokuyo's "Communication Protocol Specification for SCIP2.0"
/// (C-42-03320B).

namespace striate::pioneer {
namespace {

/// Of GD that wait for the mirror: more than a turn's worth of commands is not kept (ours)
constexpr std::size_t kMostScansAsked = 8;

}  // namespace

/// @returns the status to say; empty: a GD or GS, whose reply comes with the scan
std::string UrgDevice::ask_scans(const std::string& body, const std::string& tail) {
  const bool endless = body[0] == 'M';
  Scans scans{endless ? body.substr(0, 13) : body, tail, {}};
  scip::ScanRequest& request = scans.request;
  request.three_characters = body[1] == 'D';
  request.first_step = scip::decimal_of(body.substr(2, 4));
  request.last_step = scip::decimal_of(body.substr(6, 4));
  request.group = scip::decimal_of(body.substr(10, 2));
  if (request.first_step < 0) return "01";
  if (request.last_step < 0) return "02";
  if (request.group < 0) return "03";
  if (request.last_step > parameters_.last_step) return "04";
  if (request.last_step < request.first_step) return "05";
  // Steps that it does not measure: the specification has no status of its own for the first one.
  if (request.first_step < parameters_.first_step) return "04";
  request.group = std::max(1, request.group);
  if (clock_mode_) return "0B";
  if (!endless) {
    if (!laser_on_) return "10";
    if (asked_.size() >= kMostScansAsked) return "0B";
    asked_.push_back(std::move(scans));
    return {};
  }
  request.skip = scip::decimal_of(body.substr(12, 1));
  request.count = scip::decimal_of(body.substr(13, 2));
  if (request.skip < 0) return "06";
  if (request.count < 0) return "07";
  laser_on_ = true;
  next_scan_ = std::min(next_scan_, now_ + turn());  // whatever an earlier one skipped
  running_ = std::move(scans);
  return "00";
}

Duration UrgDevice::turn() const {
  const double rpm = parameters_.rpm * (1.0 - static_cast<double>(slower_) / kSlowerShare);
  return from_seconds(60.0 / rpm);
}

std::vector<int> UrgDevice::grouped(const scip::ScanRequest& request,
                                    const std::vector<int>& ranges_mm) const {
  std::vector<int> nearest;
  for (int at = request.first_step; at <= request.last_step; at += request.group) {
    const auto begin = ranges_mm.begin() + (at - parameters_.first_step);
    const int size = std::min(request.group, request.last_step - at + 1);
    // Below the nearest range stand the codes of rays that measured nothing: they hide nothing.
    int least = 0;
    for (auto range = begin; range != begin + size; ++range) {
      const bool measured = *range >= parameters_.nearest_mm;
      if (measured && (least < parameters_.nearest_mm || *range < least)) least = *range;
    }
    nearest.push_back(least);
  }
  return nearest;
}

void UrgDevice::step(TimePoint now, const std::vector<int>& ranges_mm) {
  now_ = now;
  if (ranges_mm.size() < rays()) return;
  const auto send = [&](const Scans& scans, const std::string& echo) {
    const std::string text =
        scip::write_reply(scip::write_scan(echo, shown_ms(), grouped(scans.request, ranges_mm),
                                           scans.request.three_characters ? 3 : 2));
    output_.insert(output_.end(), text.begin(), text.end());
  };
  if (!asked_.empty() && now >= next_turn_) {
    for (const Scans& scans : asked_) send(scans, scans.head + scans.tail);
    asked_.clear();
    next_turn_ = now + turn();
  }
  if (!running_ || now < next_scan_) return;
  scip::ScanRequest& request = running_->request;
  next_scan_ = now + turn() * (request.skip + 1);
  const bool counted = request.count > 0;
  if (counted) --request.count;
  send(*running_, running_->head + fmt::format("{:02}", request.count) + running_->tail);
  if (counted && request.count == 0) laser_off();
}

}  // namespace striate::pioneer
