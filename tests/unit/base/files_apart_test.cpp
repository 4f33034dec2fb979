#include "striate/base/files_apart.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "striate/base/files.hpp"
#include "striate/base/user_error.hpp"

namespace striate {
namespace {

namespace fs = std::filesystem;

std::string said_of(const std::vector<NamedFile>& written, const std::vector<NamedFile>& read) {
  try {
    check_apart(written, read);
  } catch (const UserError& error) {
    return error.what();
  }
  return "";
}

TEST(FilesApart, AreToldByWhateverNamesAlsoBeforeTheyAreMade) {
  const ScratchFolder folder;
  const std::string file = folder / "run.rec";
  const std::string otherwise = folder / "new/../run.rec";
  EXPECT_EQ(said_of({{"--record", file}, {"--result", otherwise}}, {}),
            "--record and --result are the same file, " + otherwise +
                "\n    give each a file of its own");
  EXPECT_THAT(said_of({{"--record", file}}, {{"the task script", file}}),
              testing::StartsWith("the task script and --record are the same file"));
  write_file(file, "here");
  fs::create_hard_link(file, folder / "linked");
  fs::create_symlink(file, folder / "pointed");
  for (const char* name : {"linked", "pointed"}) {
    EXPECT_NE(said_of({{"--record", file}, {"--result", folder / name}}, {}), "") << name;
  }
  const fs::path before = fs::current_path();
  fs::current_path(folder.path());
  EXPECT_NE(said_of({{"--record", file}, {"--result", "run.rec"}}, {}), "");
  fs::current_path(before);
}

TEST(FilesApart, OthersAreLetPass) {
  const ScratchFolder folder;
  const std::string file = folder / "a";
  EXPECT_EQ(said_of({{"--record", file}, {"--result", folder / "b"}}, {{"--world", ""}}), "");
  EXPECT_EQ(said_of({{"--record", ""}, {"--result", ""}}, {{"--world", ""}}), "");
  EXPECT_EQ(said_of({}, {{"--robot", file}, {"--world", file}}), "");
  EXPECT_EQ(said_of({{"--record", "/dev/null"}, {"--result", "/dev/null"}}, {}), "");
}

}  // namespace
}  // namespace striate
