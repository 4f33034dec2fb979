#include "striate/platform/pioneer/camera/stream_device.hpp"

#include <gtest/gtest.h>

#include <deque>

namespace striate::pioneer {
namespace {

using namespace std::chrono_literals;

/// A camera and its receiver with a line between that takes its time; steps of 10 ms.
struct Line {
  explicit Line(bool answers_in = true) : answers(answers_in) {
    device.line_up(now);
    frame.left.create(30, 40);
    frame.right.create(30, 40);
    frame.focal_px = 50.75;  // as StereoCameraSettings has it, 43 degrees wide
    frame.centre_u_px = 19.5;
    frame.centre_v_px = 14.5;
    frame.baseline_m = 0.12;
  }
  void step() {
    now += 10ms;
    device.tick(now);
    if (Bytes out = device.take_output(); !out.empty()) to_camera.emplace_back(now + there, out);
    while (!to_camera.empty() && to_camera.front().first <= now) {
      if (answers) questions.push(to_camera.front().second);
      to_camera.pop_front();
    }
    while (const auto question = questions.next()) {
      asked = true;
      send(image_stream::tell_time(*question, now.time_since_epoch() + kApart));
    }
    if (++steps % 10 == 0) show();
    Bytes in;
    while (!held && !to_us.empty() && to_us.front().first <= now) {
      append(in, to_us.front().second);
      to_us.pop_front();
    }
    if (!in.empty()) device.receive(in, now);
  }
  /// An image that was exposed 80 ms ago.
  void show() {
    frame.stamp = now - 80ms + kApart;
    Bytes packet = image_stream::encode(frame, static_cast<std::uint32_t>(steps));
    image_stream::set_age(packet, 80ms);
    if (asked) send(image_stream::tell_time(0, now.time_since_epoch() + kApart));
    send(packet);
  }
  void send(const Bytes& bytes) {
    const TimePoint due = now + back;
    to_us.emplace_back(to_us.empty() ? due : std::max(due, to_us.back().first), bytes);
  }
  void run(double seconds) {
    const TimePoint end = now + from_seconds(seconds);
    while (now < end) step();
  }
  /// Of the newest image by its stamp.
  [[nodiscard]] double age_s() const { return to_seconds(now - device.newest().stamp); }

  /// The camera's clock runs before ours.
  static constexpr Duration kApart = 777s;
  StreamDevice device{StereoCameraSettings{}};
  image_stream::QuestionReader questions;
  StereoFrame frame;
  TimePoint now{5s};
  Duration there{};
  Duration back{};
  bool answers;
  bool held = false;
  bool asked = false;
  int steps = 0;
  std::deque<std::pair<TimePoint, Bytes>> to_camera;
  std::deque<std::pair<TimePoint, Bytes>> to_us;
};

TEST(StreamDevice, AnImageIsAsOldAsItIs) {
  Line line;
  line.run(2.0);
  EXPECT_GE(line.age_s(), 0.079);
  EXPECT_LE(line.age_s(), 0.2);
}

TEST(StreamDevice, ADelayThatBeginsMakesImagesOld) {
  for (const bool answers : {true, false}) {
    Line line(answers);
    line.run(2.0);
    line.back = 3s;
    for (int i = 0; i < 800; ++i) {
      const double fresh_s = std::min(3.0, 0.01 * i);
      line.step();
      ASSERT_GE(line.age_s(), fresh_s) << answers << " " << i;
    }
    EXPECT_LT(line.age_s(), 3.4);
  }
}

TEST(StreamDevice, ADelayFromTheBeginningIsFound) {
  for (const Duration back : {Duration(800ms), Duration(3s)}) {
    Line line;
    line.back = back;
    line.run(0.1);
    for (int i = 0; i < 1500; ++i) {
      line.step();
      if (line.device.newest().left.empty()) continue;
      ASSERT_GE(line.age_s(), to_seconds(back) + 0.07) << i;
    }
    ASSERT_FALSE(line.device.newest().left.empty());
    EXPECT_LT(line.age_s(), to_seconds(back) + 0.4);
  }
}

TEST(StreamDevice, WhatWasHeldAndIsLetGoAtOnceEndsWithTheNewest) {
  Line line;
  line.run(2.0);
  line.held = true;
  line.run(3.0);
  EXPECT_GT(line.age_s(), 3.0);
  line.held = false;
  line.step();
  EXPECT_LT(line.age_s(), 0.3) << "not the oldest of the queue";
}

TEST(StreamDevice, AnAnswerThatIsOnItsWayDoesNotSpoilTheImages) {
  Bytes stream = image_stream::tell_time(7, 3s);
  append(stream, image_stream::tell_time(0, 4s));
  StereoFrame frame;
  frame.left.create(2, 2);
  frame.right.create(2, 2);
  frame.focal_px = frame.baseline_m = 1.0;
  append(stream, image_stream::encode(frame, 9));
  for (const std::size_t chunk : {std::size_t{1}, std::size_t{5}, stream.size()}) {
    image_stream::Reader reader;
    std::optional<image_stream::Image> seen;
    for (std::size_t at = 0; at < stream.size(); at += chunk) {
      reader.push(ByteView(stream).subspan(at, std::min(chunk, stream.size() - at)));
      if (auto image = reader.next()) seen = std::move(image);
    }
    ASSERT_TRUE(seen);
    EXPECT_EQ(seen->number, 9u);
    EXPECT_EQ(seen->sent, 4s);
    const auto answers = reader.take_answers();
    ASSERT_EQ(answers.size(), 1u);
    EXPECT_EQ(answers[0].question, 7u);
    EXPECT_EQ(answers[0].sent, 3s);
    EXPECT_EQ(reader.counters().junk_bytes, 0u);
  }
}

}  // namespace
}  // namespace striate::pioneer
