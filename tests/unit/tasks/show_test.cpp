#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "striate/tasks/nodes/task_node.hpp"
#include "striate/tasks/show/outline.hpp"
#include "striate/tasks/task_reader.hpp"

namespace striate::tasks {
namespace {

using testing::HasSubstr;

Outline outline_of(const std::string& yaml) {
  config::Diagnostics diagnostics(std::string(STRIATE_SOURCE_DIR "/tests/broken_tasks/t.yaml"),
                                  'T');
  Task task = read_task(yaml, diagnostics, RobotDescription{});
  EXPECT_TRUE(diagnostics.none()) << diagnostics.text();
  return std::move(task.outline);
}

const char* const kEverything =
    "striate: 1\n"
    "mission: all\n"
    "always:\n"
    "  - fail_if: {battery_below: 20 %}\n"
    "do:\n"
    "  - traverse_corridor: {speed: 0.4 m/s}\n"
    "    only_if: {after: 0 s}\n"
    "    until: {progress: 5 m}\n"
    "    within: 1.5 min\n"
    "    if_it_fails:\n"
    "      tries: 2\n"
    "      do:\n"
    "        - back_up: {}\n"
    "  - try:\n"
    "      - turn_to: {by: 20 deg}\n"
    "      - say: 'a < b & \"c\"'\n"
    "  - together:\n"
    "      - drive_straight: {}\n"
    "      - look_around: {}\n"
    "    optional: true\n"
    "  - repeat: {times: 2, do: [wait: 1 s]}\n"
    "  - use: parts/return.yaml\n"
    "    with: {speed: 0.3 m/s}\n"
    "finally:\n"
    "  - stop: {}\n";

int nodes_below(const Outline& outline) {
  int count = outline.node != nullptr ? 1 : 0;
  for (const Outline& child : outline.children) count += nodes_below(child);
  return count;
}

/// Every tag that is opened is closed in order; nothing is left.
bool is_well_formed(const std::string& xml) {
  std::vector<std::string> open;
  for (std::size_t at = xml.find('<'); at != std::string::npos; at = xml.find('<', at + 1)) {
    const std::size_t end = xml.find('>', at);
    if (end == std::string::npos) return false;
    const std::string tag = xml.substr(at + 1, end - at - 1);
    if (tag[0] == '?' || tag.back() == '/') continue;
    if (tag[0] != '/') {
      open.push_back(tag.substr(0, tag.find(' ')));
    } else if (open.empty() || open.back() != tag.substr(1)) {
      return false;
    } else {
      open.pop_back();
    }
  }
  return open.empty();
}

TEST(Show, EachStepOfAnOutlineKnowsTheNodeThatRunsIt) {
  config::Diagnostics diagnostics(std::string(STRIATE_SOURCE_DIR "/tests/broken_tasks/t.yaml"),
                                  'T');
  const Task task = read_task(kEverything, diagnostics, RobotDescription{});
  EXPECT_EQ(task.outline.node, nullptr);
  EXPECT_EQ(task.outline.children.at(0).children.at(0).node, nullptr);  // a guard
  const Outline& steps = task.outline.children.at(1);
  ASSERT_EQ(steps.children.size(), 5U);
  for (const Outline& step : steps.children) {
    ASSERT_NE(step.node, nullptr) << step.name;
    EXPECT_EQ(step.node->shown(), NodeState::waiting);
  }
  EXPECT_GT(nodes_below(task.outline), 12);
}

TEST(Show, DrawsUsedTasksWithTheirParametersInPlace) {
  const std::string text = text_tree(outline_of(kEverything));
  EXPECT_THAT(text, HasSubstr("│  └─ use parts/return.yaml {speed: 0.3 m/s}\n"
                              "│     └─ do\n"
                              "│        ├─ turn_to {heading: 180 deg}\n"
                              "│        └─ traverse_corridor {speed: 0.3 m/s}  "));
}

TEST(Show, WritesAnImageWithOneBoxANode) {
  const std::string svg = svg_tree(outline_of(kEverything));
  EXPECT_TRUE(is_well_formed(svg));
  EXPECT_THAT(svg, HasSubstr("say {text: a &lt; b &amp; &quot;c&quot;}"));
  EXPECT_THAT(svg, HasSubstr(">only if after: 0 s, until progress: 5 m, within 1.5 min<"));
}

TEST(Show, WritesTheXmlOfBehaviorTreeCpp) {
  const std::string xml = xml_tree(outline_of(kEverything));
  EXPECT_TRUE(is_well_formed(xml)) << xml;
  EXPECT_THAT(xml, HasSubstr("<root BTCPP_format=\"4\" main_tree_to_execute=\"all\">"));
  EXPECT_THAT(xml, HasSubstr("      <FailIf condition=\"battery_below\" value=\"20 %\"/>\n"));
  EXPECT_THAT(xml, HasSubstr("        <OnlyIf condition=\"after\" value=\"0 s\">\n"
                             "          <RecoveryNode number_of_retries=\"2\">\n"
                             "            <Timeout msec=\"90000\">\n"
                             "              <Until condition=\"progress\" value=\"5 m\">\n"
                             "                <traverse_corridor speed=\"0.4 m/s\"/>\n"
                             "              </Until>\n"
                             "            </Timeout>\n"
                             "            <Sequence name=\"if_it_fails\">\n"
                             "              <back_up/>\n"
                             "            </Sequence>\n"
                             "          </RecoveryNode>\n"
                             "        </OnlyIf>\n"));
  EXPECT_THAT(xml, HasSubstr("<Fallback>"));
  EXPECT_THAT(xml, HasSubstr("<Parallel success_count=\"-1\" failure_count=\"1\">"));
  EXPECT_THAT(xml, HasSubstr("<Repeat num_cycles=\"2\">"));
  EXPECT_THAT(xml, HasSubstr("<SubTree ID=\"parts/return.yaml 1\"/>"));
  EXPECT_THAT(xml, HasSubstr("<BehaviorTree ID=\"parts/return.yaml 1\">"));
  EXPECT_THAT(xml, HasSubstr("<Action ID=\"traverse_corridor\">\n"
                             "      <input_port name=\"speed\"/>\n"));
}

}  // namespace
}  // namespace striate::tasks
