#include <gtest/gtest.h>

#include "striate/config/yaml.hpp"
#include "striate/tasks/condition_reader.hpp"
#include "striate/tasks/condition_registry.hpp"

namespace striate::tasks {
namespace {

class JoinedConditions : public testing::Test {
 protected:
  static config::Node node(const std::string& yaml) {
    config::Diagnostics diagnostics("t.yaml", 'T');
    return config::parse_yaml(yaml, diagnostics);
  }
  static std::unique_ptr<Condition> condition(const std::string& yaml) {
    config::Diagnostics diagnostics("t.yaml", 'T');
    auto made = read_condition(config::parse_yaml(yaml, diagnostics), diagnostics);
    EXPECT_TRUE(diagnostics.none()) << diagnostics.text();
    return made;
  }
  static std::string mistakes(const std::string& yaml) {
    config::Diagnostics diagnostics("t.yaml", 'T');
    EXPECT_EQ(read_condition(config::parse_yaml(yaml, diagnostics), diagnostics), nullptr);
    return diagnostics.text();
  }
  static bool lasts(const std::string& yaml) { return lasts_while_standing(node(yaml)) != nullptr; }
  /// A tenth of a second in which the robot drives with this speed.
  void cycle(double forward_m_s, double light = 0.5) {
    now_ += std::chrono::milliseconds(100);
    senses_.now = now_;
    senses_.odometry.forward_m_s = forward_m_s;
    senses_.odometry.pose.x_m += 0.1 * forward_m_s;
    percept_.valid = true;
    percept_.stamp = now_;
    percept_.light_level = light;
    memory_.update(senses_, percept_);
  }
  memory::ShortTermMemory memory_{memory::ShortTermMemorySettings{}, RobotDescription{}};
  Senses senses_;
  perception::Percept percept_;
  TimePoint now_{};
};

TEST_F(JoinedConditions, HoldAsLogicSays) {
  cycle(0.0);
  const std::string yes = "{travelled: 0 m}";
  const std::string no = "{travelled: 9 m}";
  for (const bool a : {false, true}) {
    for (const bool b : {false, true}) {
      const std::string two = (a ? yes : no) + ", " + (b ? yes : no);
      EXPECT_EQ(condition("all: [" + two + "]")->holds(memory_), a && b) << two;
      EXPECT_EQ(condition("any: [" + two + "]")->holds(memory_), a || b) << two;
      EXPECT_EQ(condition("not: {any: [" + two + "]}")->holds(memory_), !(a || b)) << two;
      EXPECT_EQ(
          condition("all: [{not: " + (a ? yes : no) + "}, " + (b ? yes : no) + "]")->holds(memory_),
          !a && b)
          << two;
    }
  }
}

TEST_F(JoinedConditions, EachCountsFromTheStartOfTheStep) {
  for (int i = 0; i < 50; ++i) cycle(0.5);
  const auto both = condition("all: [{travelled: 1 m}, {after: 5 s}]");
  const auto either = condition("any: [{travelled: 1 m}, {not: {not: {after: 5 s}}}]");
  both->start(memory_);
  either->start(memory_);
  EXPECT_FALSE(either->holds(memory_));
  for (int i = 0; i < 25; ++i) cycle(0.5);
  EXPECT_TRUE(either->holds(memory_));
  EXPECT_FALSE(both->holds(memory_));
  for (int i = 0; i < 30; ++i) cycle(0.0);
  EXPECT_TRUE(both->holds(memory_));
}

TEST_F(JoinedConditions, EveryOneIsAskedInEveryCycle) {
  // `stands_for` notices a motion only in a cycle in which it is asked.
  cycle(0.0);
  const auto either = condition("any: [{light_below: 20 %}, {stands_for: 1 s}]");
  either->start(memory_);
  for (int i = 0; i < 8; ++i) cycle(0.0);
  cycle(0.5, 0.1);
  for (int i = 0; i < 2; ++i) EXPECT_TRUE(either->holds(memory_));
  for (int i = 0; i < 9; ++i) {
    cycle(0.0);
    EXPECT_FALSE(either->holds(memory_)) << i;
  }
}

TEST_F(JoinedConditions, AreShownAsTheyAreWritten) {
  const std::string text = "all: [travelled: 58 m, any: [landmark_seen: book, after: 3 s]]";
  EXPECT_EQ(condition_text(node("all: [{travelled: 58 m}, "
                                "{any: [{landmark_seen: book}, {after: 3 s}]}]")),
            text);
  EXPECT_EQ(condition_text(node(text)), text) << "what is shown can be written";
  EXPECT_EQ(condition_text(node("not: {near_start: 1 m}")), "not: {near_start: 1 m}");
}

TEST_F(JoinedConditions, AreRejectedAsAPauseThatCannotEnd) {
  for (const char* ends : {"image_older_than: 1 s", "not: {image_older_than: 1 s}",
                           "not: {after: 5 s}", "all: [{image_older_than: 1 s}, {near_start: 1 m}]",
                           "not: {any: [{light_above: 20 %}, {near_start: 1 m}]}",
                           "not: {not: {not: {after: 5 s}}}"}) {
    EXPECT_FALSE(lasts(ends)) << ends;
  }
  for (const char* lasting : {"after: 5 s", "not: {near_start: 1 m}", "not: {not: {after: 5 s}}",
                              "any: [{image_older_than: 1 s}, {near_start: 1 m}]",
                              "all: [{near_start: 1 m}, {after: 1 s}]",
                              "not: {all: [{light_above: 20 %}, {near_start: 1 m}]}"}) {
    EXPECT_TRUE(lasts(lasting)) << lasting;
  }
}

TEST_F(JoinedConditions, MistakesAreToldAtTheirPlaces) {
  EXPECT_NE(mistakes("all: {travelled: 1 m}").find("'all' must be a list of conditions"),
            std::string::npos);
  EXPECT_NE(mistakes("any: []").find("'any' must be a list of conditions, but is empty"),
            std::string::npos);
  EXPECT_NE(mistakes("not: [{travelled: 1 m}]").find("'not' must be a condition"),
            std::string::npos);
  EXPECT_NE(mistakes("{travelled: 1 m, after: 2 s}").find("join several"), std::string::npos);
  EXPECT_NE(mistakes("anny: [{after: 1 s}]").find("did you mean 'any'?"), std::string::npos);
  const std::string both = mistakes("all: [{traveled: 1 m}, {after: 1 m}]");
  EXPECT_NE(both.find("unknown condition 'traveled'"), std::string::npos) << both;
  EXPECT_NE(both.find("t.yaml:1:32"), std::string::npos) << both;
}

TEST_F(JoinedConditions, NoConditionOfAPluginTakesTheirNames) {
  for (const char* name : {"all", "any", "not"}) {
    ConditionEntry entry;
    entry.name = name;
    EXPECT_FALSE(enroll(entry)) << name;
  }
}

}  // namespace
}  // namespace striate::tasks
