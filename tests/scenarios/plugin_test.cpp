#include <nlohmann/json.hpp>

#include "striate/base/version.hpp"
#include "tests/scenarios/refused.hpp"

/// Shared objects of tests/plugins, given to the command as a user gives them.
namespace striate::scenarios {
namespace {

using testing::HasSubstr;
using testing::Not;

std::string plugin(const std::string& name) {
  return STRIATE_TEST_PLUGINS "/" + name + ".so";
}

constexpr const char* kWaves =
    "striate: 1\n"
    "mission: wave\n"
    "do:\n"
    "  - wave: 20 s\n"
    "    until: {light_is_even: 40 %}\n"
    "    within: 5 s\n"
    "  - wave: {for: 0.5 s}\n";

/// Standard error is one sentence with what and how to mend it: the message and a line with a hint.
void expect_one_sentence(const Ended& ended, const std::string& says) {
  EXPECT_EQ(ended.exit_code, 2) << ended.err;
  EXPECT_THAT(ended.err, HasSubstr(says));
  EXPECT_THAT(ended.err, HasSubstr("\n  hint: "));
  EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 2) << ended.err;
  EXPECT_THAT(ended.out, testing::IsEmpty());
}

TEST(Plugins, ATaskUsesBehaviourConditionAndStageInAWorld) {
  const TemporaryFolder folder;
  const std::string task = folder.write("wave.yaml", kWaves);
  const Ended ended = striate({"run", task, "--plugin", plugin("one_of_each"), "--world",
                               "config/worlds/short.yaml", "--json", "--record", folder / "w.rec"});
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  const auto json = nlohmann::json::parse(ended.out);
  EXPECT_LT(json.at("duration_s").get<double>(), 5.0);  // the condition ended the long wave

  // The recording says what it needs and never loads it by itself.
  expect_one_sentence(striate({"replay", folder / "w.rec"}),
                      "was recorded with the plugin 'one_of_each', which is not in use");
  const Ended again = striate({"replay", folder / "w.rec", "--plugin", plugin("one_of_each")});
  EXPECT_EQ(again.exit_code, 0) << again.out << again.err;
}

TEST(Plugins, TheCheckerKnowsTheirNamesOnlyWithThem) {
  const TemporaryFolder folder;
  const std::string task = folder.write("wave.yaml", kWaves);
  const Ended without = striate({"check", task});
  EXPECT_EQ(without.exit_code, 2);
  EXPECT_THAT(without.err, HasSubstr("unknown action 'wave'"));
  EXPECT_THAT(without.err, HasSubstr("unknown condition 'light_is_even'"));
  const Ended with = striate({"check", task, "--plugin", plugin("one_of_each")});
  EXPECT_EQ(with.exit_code, 0) << with.err;

  const std::string wrong =
      folder.write("wrong.yaml", "striate: 1\nmission: wave\ndo:\n  - wave: {for: 3 m}\n");
  const Ended mistaken = striate({"check", wrong, "--plugin", plugin("one_of_each")});
  EXPECT_EQ(mistaken.exit_code, 2);
  EXPECT_THAT(mistaken.err, HasSubstr("wrong.yaml:4:17"));
}

TEST(Plugins, AreListedLikeOurs) {
  const Ended list = striate({"task", "actions", "--plugin", plugin("one_of_each")});
  EXPECT_THAT(list.out, HasSubstr("wave: turns the head from side to side"));
  EXPECT_THAT(list.out, HasSubstr("{light_is_even: 10 %}"));
  EXPECT_THAT(striate({"task", "actions"}).out, Not(HasSubstr("wave: turns")));
}

TEST(Plugins, TheRobotsYamlNamesPluginAndBodyBesideItself) {
  const TemporaryFolder folder;
  std::filesystem::copy_file(plugin("one_of_each"), folder / "mine.so");
  const std::string robot =
      folder.write("post.yaml", "plugins: [mine.so]\nbody: {post: {gives_up_after: 20 s}}\n");
  const std::string task = folder.write("t.yaml", "striate: 1\nmission: w\ndo:\n  - wave: 2 s\n");
  const Ended ended = striate({"run", task, "--robot", robot, "--json"});
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  const Ended settings = striate({"config", "--robot", robot});
  EXPECT_THAT(settings.out, HasSubstr("body.post.gives_up_after"));

  const std::string wrong =
      folder.write("wrong.yaml", "plugins: [mine.so]\nbody: {post: {gives_up: 20 s}}\n");
  const Ended misspelt = striate({"check", wrong});
  EXPECT_EQ(misspelt.exit_code, 2);
  EXPECT_THAT(misspelt.err, HasSubstr("wrong.yaml:2:15"));
  const std::string unknown = folder.write("unknown.yaml", "body: post\n");
  const Ended missing = striate({"check", unknown});
  EXPECT_EQ(missing.exit_code, 2);
  EXPECT_THAT(missing.err, HasSubstr("unknown.yaml:1:7: error: unknown body 'post'"));
}

TEST(Plugins, ThatDoNotFitAreRefusedWithOneSentence) {
  const TemporaryFolder folder;
  const struct {
    std::string file, says;
  } rows[] = {
      {plugin("other_interface"), "interface 999, but this Striate has interface 2"},
      {plugin("other_version"), std::string("is built for Striate 0.0.7, but this is ") + kVersion},
      {plugin("other_abi"), "is built by a compiler with another"},
      {plugin("other_layout"), "is built with headers of another state of Striate"},
      {plugin("no_plugin"), "is a shared object, but no plugin of Striate"},
      {plugin("unresolved"), "cannot be loaded as a plugin: undefined symbol"},
      {folder.write("text.so", "no object"), "cannot be loaded as a plugin: "},
      {folder / "nowhere.so", "there is no such plugin"},
      {plugin("taken_action"), "has a behaviour 'stop', and that name is taken"},
      {plugin("taken_word"), "has a behaviour 'repeat', and that name is taken"},
      {plugin("taken_twice"), "has a behaviour 'idle', and that name is taken"},
      {plugin("no_name"), "has a behaviour with the name 'Idle!', which is none"},
  };
  for (const auto& row : rows) {
    SCOPED_TRACE(row.file);
    expect_one_sentence(striate({"task", "actions", "--plugin", row.file}), row.says);
  }
}

TEST(Plugins, TheSameFileTwiceIsOnePlugin) {
  const Ended ended = striate({"task", "actions", "wave", "--plugin", plugin("one_of_each"),
                               "--plugin", plugin("one_of_each")});
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
}

TEST(Plugins, WithItsOwnCopyOfALibrarySharesTheProgramsTables) {
  const std::string own = plugin("own_copy");
  EXPECT_EQ(striate({"task", "actions", "handed_in", "--plugin", own}).exit_code, 0);
  EXPECT_EQ(striate({"task", "actions", "by_itself", "--plugin", own}).exit_code, 0);
}

TEST(Plugins, TheHeadersSayTheVersionOfTheProgram) {
  EXPECT_THAT(striate({"--version"}).out, HasSubstr(kVersion));
}

}  // namespace
}  // namespace striate::scenarios
