#include "striate/platform/pioneer/camera/stream_device.hpp"

#include <algorithm>
#include <utility>

#include "striate/platform/interface/plausible.hpp"

namespace striate::pioneer {
namespace {

/// Four questions a second: 24 bytes there and back each, a thousandth of an image
constexpr Duration kAskImageSender = std::chrono::milliseconds(250);

std::string why_refused(const StereoFrame& frame, const StereoCameraSettings& expected) {
  std::string why = why_implausible(frame);
  if (!why.empty()) return why;
  why = why_of_another_camera(frame, expected.field_rad, expected.baseline_m);
  return why.empty() ? why : why + " (settings pioneer.camera.field and pioneer.camera.baseline)";
}

}  // namespace

void StreamDevice::line_up(TimePoint now) {
  reader_.clear();
  questions_.clear();
  clock_.begin_anew();
  sender_tells_ = false;
  connected_at_ = now;
  asked_at_ = now - kAskImageSender;
  output_.clear();
}

void StreamDevice::tick(TimePoint now) {
  if (now - asked_at_ < kAskImageSender) return;
  asked_at_ = now;
  asked_ = asked_ == UINT32_MAX ? 1 : asked_ + 1;  // 0 is no question
  questions_.ask(asked_, now);
  append(output_, image_stream::ask(asked_));
}

void StreamDevice::receive(ByteView bytes, TimePoint now) {
  reader_.push(bytes);
  // All that has come, to the newest: what waited on the way is older and must not be the last.
  for (auto image = reader_.next(); image; image = reader_.next()) take(std::move(*image), now);
  for (const image_stream::Answer& answer : reader_.take_answers()) {
    const auto asked = questions_.answer(answer.question);
    if (!asked) continue;
    if (!std::exchange(sender_tells_, true)) clock_.begin_anew();
    clock_.heard(answer.sent, now);
    clock_.answered(*asked, answer.sent);
  }
}

void StreamDevice::take(image_stream::Image image, TimePoint now) {
  // Before the first answer the sender's clock is made of the image's own stamp and age.
  if (sender_tells_ && !image.sent) return;
  const Duration sent = sender_tells_ ? *image.sent : image.stamp + image.age;
  clock_.heard(sent, now);
  if (!clock_.is_bounded()) clock_.answered(connected_at_, sent);
  image.frame.stamp = std::min(now, clock_.at(sent)) - image.age;
  if (image.frame.stamp < newest_.newest().stamp) return;
  std::string why = why_refused(image.frame, expected_);
  const bool good = why.empty();
  refused_.put(std::move(why));
  if (!good) return;
  newest_.put(std::move(image.frame));
}

}  // namespace striate::pioneer
