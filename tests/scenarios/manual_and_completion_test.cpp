#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/scenarios/striate_here.hpp"

namespace striate::scenarios {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// What bash offers for the last of the words, which it would have split this way.
std::vector<std::string> offered(const std::vector<std::string>& words) {
  std::string script = "source <(\"$striate\" help --completion bash) || exit 9\nCOMP_WORDS=(";
  for (const std::string& word : words) script += "'" + word + "' ";
  script += ")\nCOMP_CWORD=" + std::to_string(words.size() - 1) +
            "\n_striate\nfor one in \"${COMPREPLY[@]}\"; do echo \"$one\"; done";
  const Ended ended = bash(script);
  EXPECT_THAT(ended.err, IsEmpty());
  EXPECT_EQ(ended.exit_code, 0);
  std::vector<std::string> lines = lines_of(ended.out);
  std::sort(lines.begin(), lines.end());
  return lines;
}

bool there_is(const std::string& program) {
  return bash("command -v " + program).exit_code == 0;
}

TEST(Completion, BashOffersCommandsAtEveryDepth) {
  EXPECT_THAT(offered({"striate", "tr"}), ElementsAre("trial"));
  EXPECT_THAT(offered({"striate", "re"}), ElementsAre("recall", "recognise", "replay"));
  EXPECT_THAT(offered({"striate", "task", ""}), ElementsAre("actions", "show"));
  EXPECT_THAT(offered({"striate", "memory", "home.db", "ep"}), ElementsAre("episodes"));
  EXPECT_THAT(offered({"striate", "help", "mem"}), ElementsAre("memory"));
  EXPECT_THAT(offered({"striate", "ros", "--robot", "x", "se"}), ElementsAre("serve"));
}

TEST(Completion, BashOffersOptionsOfTheCommandAndThoseThatItPassesOn) {
  EXPECT_THAT(offered({"striate", "run", "--se"}), ElementsAre("--seed"));
  EXPECT_THAT(offered({"striate", "memory", "list", "--js"}), ElementsAre("--json"));
  EXPECT_THAT(offered({"striate", "sim", "w.yaml", "--tilt"}), ElementsAre("--tilt-deg"));
  EXPECT_THAT(offered({"striate", "--vers"}), ElementsAre("--version"));
}

TEST(Completion, BashOffersTheValuesOfAClosedSetAndFilesElsewhere) {
  EXPECT_THAT(offered({"striate", "run", "--baseline", ""}), ElementsAre("paper", "sgbm", "truth"));
  EXPECT_THAT(offered({"striate", "run", "--baseline", "=", "pa"}), ElementsAre("paper"));
  EXPECT_THAT(offered({"striate", "run", "--baseline", "="}),
              ElementsAre("paper", "sgbm", "truth"));
  EXPECT_THAT(offered({"striate", "sim", "w.yaml", "--kind", "p3dx-"}), ElementsAre("p3dx-sh"));
  EXPECT_THAT(offered({"striate", "run", "config/tasks/corr"}),
              ElementsAre("config/tasks/corridor.yaml"));
  EXPECT_THAT(offered({"striate", "run", "t.yaml", "--world", "config/worlds/shor"}),
              ElementsAre("config/worlds/short.yaml"));
  EXPECT_THAT(offered({"striate", "run", "--seed", ""}), IsEmpty());
}

TEST(Completion, AValueThatReadsLikeACommandIsNone) {
  EXPECT_THAT(offered({"striate", "memory", "--robot", "list", "--al"}), IsEmpty());
  EXPECT_THAT(offered({"striate", "memory", "list", "--al"}), ElementsAre("--all"));
}

TEST(Completion, ZshReadsItsScript) {
  const Ended script = striate_here({"help", "--completion", "zsh"});
  EXPECT_EQ(script.exit_code, 0);
  EXPECT_THAT(lines_of(script.out).front(), "#compdef striate");
  EXPECT_THAT(script.out, HasSubstr("\"striate run --baseline\") values=\"paper sgbm truth\""));
  ASSERT_TRUE(there_is("zsh")) << "cmake/packages.txt has it";
  const Ended read = bash("\"$striate\" help --completion zsh | zsh -n /dev/stdin");
  EXPECT_EQ(read.exit_code, 0) << read.err;
}

TEST(ManualPage, HasEveryCommandAndOption) {
  const Ended page = striate_here({"help", "--man"});
  ASSERT_EQ(page.exit_code, 0) << page.err;
  for (const char* section : {"NAME", "SYNOPSIS", "DESCRIPTION", "OPTIONS", "COMMANDS",
                              "EXIT STATUS", "ENVIRONMENT", "FILES", "EXAMPLES"}) {
    EXPECT_THAT(page.out, HasSubstr(std::string("\n.SH ") + section + "\n"));
  }
  EXPECT_THAT(page.out,
              AllOf(HasSubstr("\n.SS striate memory list\n"),
                    HasSubstr("\n.SS striate learn\\-descriptor\n"),
                    HasSubstr("\\fB\\-\\-tilt\\-deg\\fR \\fIFLOAT\\fR\n"),
                    HasSubstr("(from \\-60 to 60; default \\-13; only with \\-\\-picture)"),
                    HasSubstr("\\fB\\-\\-kind\\fR p3dx|p3dx\\-sh|p3at|")));
  // Every option that any help shows stands in the page.
  for (const std::string& line : lines_of(striate_here({"help", "run"}).out)) {
    const std::size_t at = line.find("  --");
    if (at != 0) continue;
    std::string name = line.substr(2, line.find_first_of(" ,", 2) - 2);
    for (std::size_t k = 0; (k = name.find('-', k)) != std::string::npos; k += 2) {
      name.replace(k, 1, "\\-");
    }
    EXPECT_THAT(page.out, HasSubstr("\\fB" + name + "\\fR")) << line;
  }
}

TEST(ManualPage, NoLineIsTakenForAnUnknownRequest) {
  const std::vector<std::string> known = {".\\\"", ".TH", ".SH", ".SS", ".TP", ".PP", ".br",
                                          ".nf",   ".fi", ".B",  ".I",  ".IR", ".BR"};
  for (const std::string& line : lines_of(striate_here({"help", "--man"}).out)) {
    if (line.empty() || (line[0] != '.' && line[0] != '\'')) continue;
    EXPECT_THAT(known, Contains(line.substr(0, line.find(' ')))) << line;
  }
}

TEST(ManualPage, GroffSetsItWithoutAWarning) {
  ASSERT_TRUE(there_is("groff")) << "cmake/packages.txt has it";
  const Ended set =
      bash("set -o pipefail\n\"$striate\" help --man | groff -man -Tutf8 -ww -P-cbou");
  EXPECT_EQ(set.exit_code, 0);
  EXPECT_THAT(set.err, IsEmpty());
  EXPECT_THAT(set.out, HasSubstr("striate memory list"));
}

}  // namespace
}  // namespace striate::scenarios
