#include "platform/pioneer/laser/urg_driver.hpp"

#include <algorithm>

#include "platform/pioneer/laser/axle_ray.hpp"

namespace striate::pioneer {

void UrgDriver::say(const std::string& line, Step step, TimePoint now) {
  append(output_, Bytes(line.begin(), line.end()));
  output_.push_back('\n');
  step_ = step;
  said_at_ = now;
}

Bytes UrgDriver::take_output() {
  Bytes bytes;
  bytes.swap(output_);
  return bytes;
}

void UrgDriver::close() {
  say("QT", Step::closed, said_at_);
}

void UrgDriver::receive(ByteView bytes, TimePoint now) {
  stream_.push(bytes);
  while (const auto reply = stream_.next()) take(*reply, now);
}

void UrgDriver::take(const scip::Reply& reply, TimePoint now) {
  const std::string kind = reply.echo.substr(0, 2);
  switch (step_) {
    case Step::protocol:
      // Devices that speak SCIP 2.0 already refuse the change, which is as good.
      if (kind == "SC") say("QT", Step::quiet, now);
      return;
    case Step::quiet:
      if (kind == "QT") say("PP", Step::ask, now);
      return;
    case Step::ask:
      if (const auto parameters = scip::read_parameters(reply)) {
        parameters_ = *parameters;
        say("BM", Step::laser_on, now);
      }
      return;
    case Step::laser_on:
      if (kind == "BM" && (reply.status == "00" || reply.status == "02")) {
        scip::ScanRequest request;
        request.first_step = parameters_.first_step;
        request.last_step = parameters_.last_step;
        say(scip::write_request(request), Step::scan, now);
        scanned_at_ = now;
      }
      return;
    case Step::scan:
      take_scan(reply, now);
      return;
    case Step::begin:
    case Step::closed:
      return;
  }
}

void UrgDriver::take_scan(const scip::Reply& reply, TimePoint now) {
  if (reply.status != "99") return;
  const auto scan = scip::read_scan(reply, parameters_);
  if (!scan) return;
  scanned_at_ = now;
  // The first ray is a turn of the mirror older than the end of the reply.
  scan_.stamp = now - from_seconds(60.0 / std::max(1, parameters_.rpm));
  scan_.readings.clear();
  for (const scip::Ray& ray : scan->rays) {
    scan_.readings.push_back(axle_ray(settings_.forward_m, ray.bearing_rad, ray.distance_m));
  }
}

void UrgDriver::tick(TimePoint now) {
  switch (step_) {
    case Step::closed:
      return;
    case Step::begin:
      break;
    case Step::scan:
      if (now - scanned_at_ < from_seconds(settings_.begin_again_after_s)) return;
      break;
    default:
      if (now - said_at_ < from_seconds(settings_.reply_patience_s)) return;
  }
  ++set_ups_;
  say("SCIP2.0", Step::protocol, now);
}

RangeScan UrgDriver::scan(TimePoint now) const {
  if (now - scan_.stamp > from_seconds(settings_.stale_after_s)) return {};
  return scan_;
}

}  // namespace striate::pioneer
