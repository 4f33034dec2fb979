#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/scenarios/refused.hpp"

namespace striate::scenarios {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

TEST(ForgivingCommandLine, AnUnknownCommandNamesTheNearest) {
  expect_refused({
      {{"trail"}, "striate: unknown command 'trail'\n  hint: did you mean 'trial'?\n"},
      {{"trail", "--help"}, "striate: unknown command 'trail'\n  hint: did you mean 'trial'?\n"},
      {{"memory", "home.db", "lits"},
       "striate memory: unknown command 'lits'\n  hint: did you mean 'list'?\n"},
      {{"task", "shwo"}, "striate task: unknown command 'shwo'\n  hint: did you mean 'show'?\n"},
      {{"ros", "rpelay"}, "striate ros: unknown command 'rpelay'\n  hint: did you mean 'replay'?"},
      {{"eval", "sterio", "data"}, "hint: did you mean 'stereo'?"},
      {{"help", "memory", "lits"},
       "striate memory: unknown command 'lits'\n  hint: did you mean 'list'?\n"},
      {{"xyzzyplugh"}, "unknown command 'xyzzyplugh'\n  hint: 'striate --help' lists them\n"},
      {{"task"}, "striate task: a command is missing: one of show, actions\n"},
  });
}

TEST(ForgivingCommandLine, AnUnknownOptionNamesTheNearest) {
  expect_refused({
      {{"run", "--sed", "7"},
       "striate run: unknown option '--sed'\n  hint: did you mean '--seed'?"},
      {{"run", "t.yaml", "--sed=7"}, "unknown option '--sed'\n  hint: did you mean '--seed'?"},
      {{"memory", "x.db", "list", "--jsno"}, "hint: did you mean '--json'?"},
      {{"trial", "merge", "a", "--uot", "b"}, "hint: did you mean '--out'?"},
      {{"--versoin"}, "striate: unknown option '--versoin'\n  hint: did you mean '--version'?"},
      {{"sim", "w.yaml", "more"}, "striate sim: nothing takes 'more'"},
  });
}

TEST(ForgivingCommandLine, HelpOfACommandIsWhatItsOptionPrints) {
  for (const Words& command : std::vector<Words>{
           {}, {"run"}, {"memory"}, {"memory", "list"}, {"trial", "merge"}, {"eval", "stereo"}}) {
    Words help = {"help"};
    help.insert(help.end(), command.begin(), command.end());
    Words option = command;
    option.emplace_back("--help");
    const Ended by_command = striate_here(help);
    EXPECT_EQ(by_command.exit_code, 0) << by_command.err;
    EXPECT_THAT(by_command.out, HasSubstr("Usage: striate"));
    EXPECT_EQ(by_command.out, striate_here(option).out) << testing::PrintToString(command);
  }
}

TEST(ForgivingCommandLine, OneActionIsShownWithItsParameters) {
  const Ended ended = striate_here({"task", "actions", "back_up"});
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_THAT(ended.out, testing::StartsWith("  back_up: drives straight back\n"));
  EXPECT_THAT(ended.out, testing::ContainsRegex("distance +0.3 m +how far \\(0.02 m .. 5 m\\)"));
  EXPECT_THAT(ended.out, AllOf(Not(HasSubstr("traverse_corridor")), Not(HasSubstr("Conditions"))));
  const auto json =
      nlohmann::json::parse(striate_here({"task", "actions", "back_up", "--json"}).out);
  EXPECT_EQ(json.at("actions").size(), 1U);
  EXPECT_THAT(striate_here({"task", "actions", "battery_below"}).out,
              HasSubstr("{battery_below: 20 %}"));
  expect_refused({{{"task", "actions", "bakc_up"}, "hint: did you mean 'back_up'?"}});
}

TEST(ForgivingCommandLine, AnOldNameStillWorksAndSaysTheNewOne) {
  const TemporaryFolder folder;
  const auto image = [&](const std::string& file, const std::string& option) {
    return striate_here(
        {"sim", "config/worlds/short.yaml", "--picture", folder / file, option, "-20"});
  };
  const Ended before = image("old.png", "--tilt");
  EXPECT_EQ(before.exit_code, 0) << before.err;
  EXPECT_THAT(before.err, HasSubstr("striate sim: --tilt is now called --tilt-deg"));
  const Ended after = image("new.png", "--tilt-deg");
  EXPECT_EQ(after.exit_code, 0) << after.err;
  EXPECT_THAT(after.err, IsEmpty());
  EXPECT_EQ(read_text(folder / "old.png"), read_text(folder / "new.png"));
}

/// Each: the command, its old option, a value, the new name. The rest is wrong: nothing is done.
TEST(ForgivingCommandLine, EachRenamedOptionIsKnownByItsOldNameAndShownByItsNewOne) {
  const std::vector<std::vector<std::string>> rows = {
      {"sim", "--pan", "5", "--pan-deg"},
      {"sim", "--width", "64", "--width-px"},
      {"sim", "--delay", "0.1", "--delay-s"},
      {"sim", "--silent-at", "1", "--silent-at-s"},
      {"sim", "--silent-for", "1", "--silent-for-s"},
      {"sim", "--laser-silent-at", "1", "--laser-silent-at-s"},
      {"sim", "--turret-sticks-at", "1", "--turret-sticks-at-s"},
      {"sim", "--break-at", "1", "--break-at-s"},
      {"drive", "--forward", "0.1", "--forward-m-s"},
      {"drive", "--turn", "5", "--turn-deg-s"},
      {"drive", "--for", "1", "--for-s"},
      {"drive", "--way", "1", "--way-m"},
      {"perceive", "--width", "64", "--width-px"},
      {"calibrate", "--square", "25", "--square-mm"},
      {"learn-descriptor", "--pictures", "3", "--picture-count"},
  };
  for (const auto& row : rows) {
    const Ended ended = striate_here({row[0], row[1], row[2], "--no-such-option"});
    EXPECT_EQ(ended.exit_code, 2);
    EXPECT_THAT(ended.err, AllOf(HasSubstr(row[1] + " is now called " + row[3]),
                                 HasSubstr("unknown option '--no-such-option'")));
    const std::string help = striate_here({"help", row[0]}).out;
    EXPECT_THAT(help, AllOf(HasSubstr(row[3] + " "), Not(HasSubstr(row[1] + " ")))) << row[0];
  }
}

TEST(ForgivingCommandLine, ASeedIsAWholeNumberInItsRange) {
  const std::string range = "no whole number from 0 to 18446744073709551615";
  for (const std::string bad : {"-1", "18446744073709551616", "1.5", "seven", "0x10"}) {
    expect_refused({
        {{"run", "t.yaml", "--world", "w.yaml", "--seed", bad},
         "--seed: '" + bad + "' is " + range},
        {{"trial", "--first-seed", bad}, "--first-seed: '" + bad + "' is " + range},
        {{"sim", "w.yaml", "--seed", bad}, range},
        {{"teach", "book", "--world", "w.yaml", "--seed", bad}, range},
        {{"learn-descriptor", "--seed", bad}, range},
        {{"ros", "serve", "--world", "w.yaml", "--seed", bad}, range},
    });
  }
  expect_refused({{{"recall", "run.rec", "--cycle", "0"}, "no whole number from 1 to"}});
}

TEST(ForgivingCommandLine, OfAnOptionGivenTwiceTheLastCounts) {
  const std::vector<std::string> words = {
      "run",    "config/tasks/corridor.yaml", "--world", "w.yaml", "--seed", "7", "--seed", "3",
      "--world"};
  expect_refused({{with(words, "last.yaml"), "last.yaml"}});
}

TEST(ForgivingCommandLine, AnOptionThatDoesNothingAloneSaysWhatItNeeds) {
  expect_refused({
      {{"run", "t.yaml", "--seed", "3"}, "--seed requires --world"},
      {{"run", "t.yaml", "--baseline", "sgbm"}, "--baseline requires --world"},
      {{"run", "t.yaml", "--pictures", "p"}, "--pictures requires --world"},
      {{"run", "t.yaml", "--world", "w.yaml", "--picture-every", "3"},
       "--picture-every requires --pictures"},
      {{"replay", "r.rec", "--picture-every", "3"}, "--picture-every requires --pictures"},
      {{"replay", "r.rec", "--pictures", "p"}, "--pictures requires --picture-every"},
      {{"ros", "replay", "a.bag", "--picture-every", "3"}, "--picture-every requires --out"},
      {{"ros", "serve", "--seed", "3"}, "--seed requires --world"},
      {{"trial", "--only", "book"}, "--only requires --objects"},
      {{"trial", "--objects", "--jobs", "2", "--out", "o"}, "--objects"},
      {{"sim", "w.yaml", "--at", "1 m, 0 m, 0 deg"}, "--at requires --picture"},
      {{"sim", "w.yaml", "--tilt-deg", "-20", "--serve"}, "--tilt-deg requires --picture"},
      {{"sim", "w.yaml", "--port", "8101"}, "--port does nothing without --serve or --pty"},
      {{"sim", "w.yaml", "--serve", "--silent-for-s", "1"},
       "--silent-for-s requires --silent-at-s"},
      {{"teach", "book", "--at", "1 m, 0 m, 0 deg"}, "--at requires --world"},
      {{"teach", "book", "--when", "3 s"}, "--when requires --from"},
      {{"perceive", "--left", "l.png", "--out", "o", "--candidates", "9"}, "requires --right"},
      {{"perceive", "--left", "l.png", "--out", "o", "--tilt-deg", "9"},
       "--tilt-deg requires --camera-height-m"},
      {{"drive", "tcp://localhost:1", "--forward-m-s", "0.1"},
       "nothing without --for-s or --way-m"},
  });
}

}  // namespace
}  // namespace striate::scenarios
