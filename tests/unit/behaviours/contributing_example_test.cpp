#include "tests/unit/behaviours/contributing_example.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "striate/behaviours/registry.hpp"
#include "striate/config/yaml.hpp"
#include "tests/reference/flat_run.hpp"

namespace striate::behaviours {
namespace {

std::string content(const std::string& file) {
  std::ifstream stream(std::string(STRIATE_SOURCE_DIR "/") + file);
  std::stringstream text;
  text << stream.rdbuf();
  return text.str();
}

/// The first C++ block of a Markdown text, without the indentation of its list.
std::string first_block(const std::string& markdown) {
  std::istringstream lines(markdown.substr(markdown.find("```cpp")));
  std::string block;
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line) && line.find("```") == std::string::npos) {
    block += line.substr(std::min<std::size_t>(3, line.size())) + "\n";
  }
  return block;
}

TEST(ContributingExample, StandsInTheGuideAsItIsCompiledHere) {
  const std::string block = first_block(content("CONTRIBUTING.md"));
  EXPECT_GT(block.size(), 500U);
  EXPECT_THAT(content("tests/unit/behaviours/contributing_example.hpp"), testing::HasSubstr(block));
}

TEST(ContributingExample, IsRegisteredWithOneLineAndNods) {
  const BehaviourEntry entry = behaviour_entry<Nod>("nod", "moves the head up and down");
  EXPECT_EQ(entry.parameters().size(), 2U);
  config::Diagnostics diagnostics("t.yaml");
  const config::Node root = config::parse_yaml("nod: 1.5 s\n", diagnostics);
  flat::Loop loop({}, 1);
  const auto nod = entry.make(root.entries.front().value, diagnostics, loop.robot);
  ASSERT_TRUE(diagnostics.none()) << diagnostics.text();
  double highest_rad = -1.0;
  double lowest_rad = 1.0;
  const flat::RunResult result = loop.run(*nod, 10.0, [&](const Wish& wish) {
    highest_rad = std::max(highest_rad, wish.tilt_rad);
    lowest_rad = std::min(lowest_rad, wish.tilt_rad);
  });
  EXPECT_EQ(result.progress, Progress::succeeded);
  EXPECT_NEAR(result.duration_s, 1.8, 0.15);
  EXPECT_GT(highest_rad - lowest_rad, 0.3);
}

}  // namespace
}  // namespace striate::behaviours
