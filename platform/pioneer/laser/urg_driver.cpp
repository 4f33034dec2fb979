#include "striate/platform/pioneer/laser/urg_driver.hpp"

#include <algorithm>

#include "striate/platform/interface/seen_from_axle.hpp"

namespace striate::pioneer {
namespace {

/// The device's clock: milliseconds in 24 bits, 4.7 hours a turn; SCIP 2.0
constexpr int kShownTurn_ms = 1 << 24;

}  // namespace

void UrgDriver::say(const std::string& line, Step step, TimePoint now) {
  Bytes bytes(line.begin(), line.end());
  bytes.push_back('\n');
  talk_.say(bytes, step, now);
}

void UrgDriver::close() {
  say("QT", Step::closed, talk_.said_at());
}

void UrgDriver::receive(ByteView bytes, TimePoint now) {
  stream_.push(bytes);
  while (const auto reply = stream_.next()) take(*reply, now);
}

void UrgDriver::take(const scip::Reply& reply, TimePoint now) {
  const std::string kind = reply.echo.substr(0, 2);
  switch (talk_.step()) {
    case Step::protocol:
      // Devices that speak SCIP 2.0 already refuse the change, which is as good.
      if (kind == "SC") say("QT", Step::quiet, now);
      return;
    case Step::quiet:
      if (kind == "QT") say("TM0", Step::clock_on, now);
      return;
    case Step::clock_on:
      if (kind != "TM") return;
      if (reply.status == "00" || reply.status == "02") {  // 02: it has been asked before
        say(clock_question(), Step::clock, now);
      } else {
        say("PP", Step::ask, now);  // a device that does not tell
      }
      return;
    case Step::clock:
      // Its own question comes back with the answer, so an older answer is not taken for it.
      if (reply.echo == clock_question()) take_clock(reply, now);
      return;
    case Step::clock_off:
      if (kind == "TM") say("PP", Step::ask, now);
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
        talk_.expect_scans(now);
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
  const Duration sent = device_time(scan->device_time_ms);
  clock_.heard(sent, now);
  // The first ray is a turn of the mirror older than the end of the reply.
  const Duration turn = from_seconds(60.0 / std::max(1, parameters_.rpm));
  RangeScan& seen = talk_.begin_scan(std::min(now, clock_.at(sent)) - turn, now);
  for (const scip::Ray& ray : scan->rays) {
    seen.readings.push_back(
        seen_from_axle({talk_.settings().forward_m, 0.0, ray.bearing_rad}, ray.distance_m));
  }
}

std::string UrgDriver::clock_question() const {
  return "TM1;" + std::to_string(talk_.set_ups());
}

Duration UrgDriver::device_time(int shown_ms) {
  const int on = (shown_ms - shown_ms_ + kShownTurn_ms) % kShownTurn_ms;
  shown_ms_ = shown_ms;
  device_time_ += std::chrono::milliseconds(on < kShownTurn_ms / 2 ? on : on - kShownTurn_ms);
  return device_time_;
}

void UrgDriver::take_clock(const scip::Reply& reply, TimePoint now) {
  const int shown_ms = reply.status == "00" ? scip::read_time(reply) : -1;
  if (shown_ms >= 0) {
    clock_.begin_anew();
    const Duration shown = device_time(shown_ms);
    clock_.heard(shown, now);
    clock_.answered(talk_.said_at(), shown);
  }
  say("TM2", Step::clock_off, now);
}

void UrgDriver::tick(TimePoint now) {
  if (talk_.begins(now)) say("SCIP2.0", Step::protocol, now);
}

}  // namespace striate::pioneer
