#include "striate/platform/pioneer/line_clock.hpp"

#include <gtest/gtest.h>

#include <deque>

#include "striate/platform/pioneer/questions.hpp"
#include "striate/platform/pioneer/round_trip.hpp"

namespace striate::pioneer {
namespace {

using namespace std::chrono_literals;

/// The sender's clock is 1000 s ahead of ours.
Duration sender(Duration ours) {
  return ours + 1000s;
}

TEST(LineClock, AnAnswerBoundsADelayThatWasThereFromTheBeginning) {
  LineClock clock;
  for (Duration sent = 0s; sent < 10s; sent += 100ms) {
    const TimePoint arrived(sent + 3s);
    clock.heard(sender(sent), arrived);
    if (sent == 1s) {
      EXPECT_EQ(clock.at(sender(sent)), arrived) << "nobody has answered yet";
    }
    // Asked just before it was sent, since only the way here is late.
    if (sent == 2s) clock.answered(TimePoint(sent - 5ms), sender(sent));
    if (sent > 2s) {
      EXPECT_NEAR(to_seconds(clock.at(sender(sent))), to_seconds(sent), 0.01);
    }
  }
}

TEST(LineClock, NothingWasSentAfterItArrivedNorBeforeTheQuestionItAnswers) {
  LineClock clock;
  for (int i = 0; i < 600; ++i) {
    const Duration sent = i * 100ms;
    const Duration there = (i * 37 % 50) * 1ms;
    const Duration back = (i * 23 % 70) * 1ms;
    clock.heard(sender(sent), TimePoint(sent + back));
    clock.answered(TimePoint(sent - there), sender(sent));
    EXPECT_LE(clock.at(sender(sent)), TimePoint(sent + back));
    EXPECT_GE(clock.at(sender(sent)), TimePoint(sent - there - 1ms));
  }
}

TEST(LineClock, WithoutAnswersWhatPilesUpIsOld) {
  LineClock clock;
  for (int i = 0; i < 50; ++i) {
    const Duration sent = i * 100ms;
    const TimePoint arrived(sent + i * 60ms);
    clock.heard(sender(sent), arrived);
    EXPECT_NEAR(to_seconds(arrived - clock.at(sender(sent))), 0.06 * i, 0.005);
  }
}

TEST(LineClock, FollowsClocksThatDriftAndBeginsAnewWhenOneIsSet) {
  for (const double drift : {-1e-4, 1e-4}) {
    LineClock clock;
    for (int i = 0; i < 36000; ++i) {  // an hour
      const Duration now = i * 100ms;
      const Duration shown = from_seconds(to_seconds(now) * (1.0 + drift));
      clock.heard(shown, TimePoint(now));
      if (i % 3 == 0) clock.answered(TimePoint(now - 4ms), shown);
      ASSERT_NEAR(to_seconds(clock.at(shown)), to_seconds(now), 0.02) << drift << " " << i;
    }
    clock.heard(5s, TimePoint(2h));
    EXPECT_EQ(clock.at(5s), TimePoint(2h));
  }
}

TEST(Questions, AnAnswerSaysThatOlderOnesAreLost) {
  Questions<int> questions;
  questions.ask(1, TimePoint(1s));
  questions.ask(2, TimePoint(2s));
  EXPECT_EQ(questions.oldest(), TimePoint(1s));
  EXPECT_EQ(questions.answer(2), TimePoint(2s));
  EXPECT_FALSE(questions.answer(1)) << "its answer would have come first";
  EXPECT_FALSE(questions.oldest());
}

TEST(Questions, OfTwoAlikeTheOlderCounts) {
  Questions<int> questions;
  questions.ask(1, TimePoint(1s));
  questions.ask(1, TimePoint(2s));
  EXPECT_EQ(questions.answer(1), TimePoint(1s));
  EXPECT_EQ(questions.answer(1), TimePoint(2s));
}

/// A line with a robot at its other end that answers after so long; `lost` of the questions go.
Duration worst_delay(Duration takes, int every_lost, Duration from = 1s) {
  RoundTrip trip;
  trip.begin(TimePoint());
  std::deque<std::pair<TimePoint, RoundTrip::Question>> answers;
  Duration worst{};
  int asked = 0;
  for (TimePoint now; now < TimePoint(20s); now += 10ms) {
    while (!answers.empty() && answers.front().first <= now) {
      trip.answered(answers.front().second, now);
      answers.pop_front();
    }
    if (const auto question = trip.asks(now)) {
      const bool lost = every_lost > 0 && ++asked % every_lost == 0;
      if (!lost) answers.emplace_back(now + takes, *question);
    }
    if (now.time_since_epoch() > from) worst = std::max(worst, trip.delay(now).value_or(1h));
  }
  return worst;
}

TEST(RoundTrip, IsWhatTheLineTakesThereAndBack) {
  EXPECT_EQ(worst_delay(20ms, 0), 20ms);
  EXPECT_EQ(worst_delay(800ms, 0, 0s), 1h) << "not known before the first answer";
  EXPECT_GE(worst_delay(800ms, 0, 5s), 800ms);
}

TEST(RoundTrip, ALostAnswerIsFoundByTheNextQuestionAndNoLateLine) {
  EXPECT_LT(worst_delay(30ms, 5), 200ms);
  EXPECT_LT(worst_delay(100ms, 7), 350ms);
}

TEST(RoundTrip, AnAnswerThatIsThreeSecondsLateIsNotTakenForThatToALaterQuestion) {
  RoundTrip trip;
  trip.begin(TimePoint());
  std::vector<std::pair<TimePoint, RoundTrip::Question>> asked;
  for (TimePoint now; now < TimePoint(3s); now += 10ms) {
    if (const auto question = trip.asks(now)) asked.emplace_back(now, *question);
  }
  ASSERT_FALSE(asked.empty());
  for (const auto& [at, question] : asked) {
    trip.answered(question, at + 3s);
    EXPECT_EQ(trip.measured(), 3s);
    EXPECT_GE(trip.delay(at + 3s), 3s);
  }
}

}  // namespace
}  // namespace striate::pioneer
