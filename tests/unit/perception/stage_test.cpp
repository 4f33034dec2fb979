#include "striate/perception/stage.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "striate/perception/perception.hpp"

namespace striate::perception {
namespace {

/// Says how often it was called, and, in its second figure, nothing.
class Counter final : public Stage {
 public:
  void see(const StereoFrame& frame, const Percept& percept, std::span<double> figures) override {
    EXPECT_EQ(percept.stamp, frame.stamp);
    EXPECT_TRUE(percept.valid);
    EXPECT_GT(percept.light_level, 0.0);  // our own stages have run
    figures[0] = ++calls_;
  }

 private:
  int calls_ = 0;
};

StageEntry counter(const std::string& name) {
  return {name, "", {"calls", "never"}, [](const RobotDescription&) {
            return std::make_unique<Counter>();
          }};
}

StereoFrame grey_frame(int number) {
  StereoFrame frame;
  frame.stamp = TimePoint(std::chrono::milliseconds(100 * number));
  frame.left = cv::Mat3b(120, 160, cv::Vec3b::all(90));
  return frame;
}

TEST(Stages, RunAfterOursInTheirOrderOnceAnImage) {
  StageRegistry stages;
  ASSERT_TRUE(stages.add(counter("first")));
  ASSERT_TRUE(stages.add(counter("second")));
  ASSERT_FALSE(stages.add(counter("first")));
  PerceptionExtras extras;
  extras.stages = &stages;
  Perception perception({}, {}, extras);
  (void)perception.see(grey_frame(1));
  (void)perception.see({});  // no image: nothing to see
  const Percept percept = perception.see(grey_frame(2));
  ASSERT_EQ(percept.figures.size(), 4U);
  EXPECT_EQ(percept.figures[0].name.view(), "first.calls");
  EXPECT_EQ(percept.figures[0].value, 2.0);
  EXPECT_EQ(percept.figures[2].name.view(), "second.calls");
  EXPECT_EQ(percept.figures[2].value, 2.0);
}

TEST(Stages, AFigureThatIsNotSaidIsNotKnown) {
  StageRegistry stages;
  ASSERT_TRUE(stages.add(counter("one")));
  PerceptionExtras extras;
  extras.stages = &stages;
  Perception perception({}, {}, extras);
  const Percept percept = perception.see(grey_frame(1));
  ASSERT_EQ(percept.figures.size(), 2U);
  EXPECT_TRUE(std::isnan(percept.figures[1].value));
}

TEST(Stages, WithoutAnyThereAreNoFigures) {
  Perception perception({}, {});
  EXPECT_TRUE(perception.see(grey_frame(1)).figures.empty());
}

}  // namespace
}  // namespace striate::perception
