#include "striate/platform/pioneer/who_answers.hpp"

#include <gtest/gtest.h>

#include <functional>

#include "striate/platform/pioneer/camera/image_stream.hpp"
#include "striate/platform/pioneer/firmware/arcos_firmware.hpp"
#include "striate/platform/pioneer/firmware/lms_device.hpp"
#include "striate/platform/pioneer/firmware/servo_bus.hpp"
#include "striate/platform/pioneer/firmware/urg_device.hpp"
#include "tests/unit/pioneer/test_bed.hpp"

namespace striate::pioneer {
namespace {

using namespace std::chrono_literals;

/// A line at whose other end something answers at once.
class AnsweringLine : public MemoryLine {
 public:
  explicit AnsweringLine(std::function<Bytes(ByteView)> answer) : answer_(std::move(answer)) {
    open();
  }
  void write(ByteView bytes) override {
    ++words;
    append(to_program, answer_(bytes));
  }
  int words = 0;

 private:
  std::function<Bytes(ByteView)> answer_;
};

/// Whatever was expected.
void expect_heard(const std::function<Bytes(ByteView)>& answer, Answerer device) {
  for (const Answerer expected :
       {Answerer::base, Answerer::turret, Answerer::hokuyo, Answerer::lms200, Answerer::camera}) {
    AnsweringLine line(answer);
    EXPECT_EQ(who_answers(line, expected, {}, 15ms), device)
        << name_of(device) << " where " << name_of(expected) << " was expected";
  }
}

TEST(WhoAnswers, KnowsEachDeviceWhateverWasExpected) {
  ArcosFirmware base{FirmwareSettings{}};
  expect_heard(
      [&](ByteView bytes) {
        base.receive(bytes, TimePoint(1s));
        return base.take_output();
      },
      Answerer::base);
  ServoBus turret{{ServoModel(2, 0.0)}};
  expect_heard(
      [&](ByteView bytes) {
        turret.receive(bytes);
        turret.step(500ms);
        return turret.take_output();
      },
      Answerer::turret);
  UrgDevice urg;
  expect_heard(
      [&](ByteView bytes) {
        urg.receive(bytes);
        return urg.take_output();
      },
      Answerer::hokuyo);
  LmsDevice lms;
  TimePoint now(1s);
  expect_heard(
      [&](ByteView bytes) {
        lms.receive(bytes);
        lms.step(now += 500ms, {});
        return lms.take_output();
      },
      Answerer::lms200);
  expect_heard(
      [](ByteView bytes) {
        image_stream::QuestionReader reader;
        reader.push(bytes);
        const auto question = reader.next();
        return question ? image_stream::tell_time(*question, 5s) : Bytes{};
      },
      Answerer::camera);
}

TEST(WhoAnswers, TakesNoEchoForADevice) {
  expect_heard([](ByteView bytes) { return Bytes(bytes.begin(), bytes.end()); }, Answerer::nobody);
  expect_heard([](ByteView) { return Bytes{}; }, Answerer::nobody);
}

TEST(WhoAnswers, SaysNoWordToABaseWithAnOpenSession) {
  AnsweringLine line([](ByteView) { return Bytes{}; });
  line.to_program = arcos::encode(arcos::write_sip({}));
  EXPECT_EQ(who_answers(line, Answerer::hokuyo, {}, 15ms), Answerer::base);
  EXPECT_EQ(line.words, 0) << "the first one would wake what it did before";
}

}  // namespace
}  // namespace striate::pioneer
