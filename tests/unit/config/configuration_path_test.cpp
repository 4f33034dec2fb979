#include "striate/config/configuration_path.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "striate/base/user_error.hpp"
#include "tests/reference/temporary_folder.hpp"

namespace striate::config {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

std::vector<std::string> paths_of(const std::vector<ConfigurationFolder>& folders) {
  std::vector<std::string> paths;
  for (const ConfigurationFolder& folder : folders) paths.push_back(folder.path.string());
  return paths;
}

/// Two configurations, as the shipped one and the user's own.
class ConfigurationPath : public testing::Test {
 protected:
  void write(const std::string& file) {
    fs::create_directories(fs::path(root_ / file).parent_path());
    (void)root_.write(file, "x: 1\n");
  }
  [[nodiscard]] std::string find(const std::string& given, FileKind kind) const {
    return find_configuration(given, kind, folders_);
  }
  /// The path below the temporary folder.
  [[nodiscard]] std::string found(const std::string& given, FileKind kind) const {
    return fs::path(find(given, kind)).lexically_relative(root_.path()).string();
  }

  reference::TemporaryFolder root_;
  std::vector<ConfigurationFolder> folders_ = {{root_ / "shipped", "shipped"},
                                               {root_ / "own", "your own"}};
};

TEST(ConfigurationFolders, AreBesideTheProgramThenInstalledThenTheUsersOwn) {
  EXPECT_THAT(paths_of(configuration_folders_of("/x/bin", nullptr, "/home/u")),
              ElementsAre("/x/bin/config", "/x/share/striate/config", "/home/u/.config/striate"));
  EXPECT_THAT(paths_of(configuration_folders_of("/x/bin", "/y", "/home/u")),
              ElementsAre("/x/bin/config", "/x/share/striate/config", "/y/striate"));
  EXPECT_THAT(paths_of(configuration_folders_of("/x/bin", "not/absolute", "")),
              ElementsAre("/x/bin/config", "/x/share/striate/config"));
}

TEST_F(ConfigurationPath, ABareNameStandsInTheFolderOfItsKindWithOrWithoutYaml) {
  write("shipped/tasks/walk.yaml");
  write("own/worlds/walk.yaml");
  EXPECT_EQ(found("walk", FileKind::task), "shipped/tasks/walk.yaml");
  EXPECT_EQ(found("walk.yaml", FileKind::task), "shipped/tasks/walk.yaml");
  EXPECT_EQ(found("walk", FileKind::world), "own/worlds/walk.yaml");
  EXPECT_EQ(found("walk", FileKind::any), "shipped/tasks/walk.yaml");
}

TEST_F(ConfigurationPath, APathThatBeginsWithConfigLeadsIntoEachConfiguration) {
  write("own/tasks/parts/turn.yaml");
  EXPECT_EQ(found("config/tasks/parts/turn.yaml", FileKind::task), "own/tasks/parts/turn.yaml");
  EXPECT_EQ(found("config/tasks/parts/turn", FileKind::world), "own/tasks/parts/turn.yaml");
}

TEST_F(ConfigurationPath, TheShippedFileGoesBeforeOneOfTheUsersOwn) {
  write("own/robots/pioneer.yaml");
  EXPECT_EQ(found("pioneer", FileKind::robot), "own/robots/pioneer.yaml");
  write("shipped/robots/pioneer.yaml");
  EXPECT_EQ(found("pioneer", FileKind::robot), "shipped/robots/pioneer.yaml");
}

TEST_F(ConfigurationPath, WhatIsThereAsGivenIsTakenAsGiven) {
  write("here/walk.yaml");
  write("shipped/tasks/walk.yaml");
  const fs::path before = fs::current_path();
  fs::current_path(root_ / "here");
  EXPECT_EQ(find("walk.yaml", FileKind::task), "walk.yaml");
  EXPECT_EQ(find("walk", FileKind::task), "walk.yaml");
  fs::current_path(before);
  EXPECT_EQ(find(root_ / "nothing.yaml", FileKind::task), root_ / "nothing.yaml");
  EXPECT_EQ(find("my/nothing.yaml", FileKind::task), "my/nothing.yaml");
  EXPECT_EQ(find("", FileKind::robot), "");
}

TEST_F(ConfigurationPath, WhatIsNowhereIsSaidWithEveryPlaceAndTheNearestName) {
  write("shipped/tasks/corridor.yaml");
  try {
    (void)find("coridor", FileKind::task);
    FAIL() << "found";
  } catch (const UserError& error) {
    EXPECT_THAT(
        error.what(),
        AllOf(HasSubstr("coridor: error: there is no such file; looked at:"),
              HasSubstr("\n      coridor.yaml\n"), HasSubstr(root_ / "shipped/tasks/coridor.yaml"),
              HasSubstr(root_ / "own/tasks/coridor.yaml"), HasSubstr("did you mean 'corridor'?"),
              HasSubstr("striate config --paths")));
  }
}

}  // namespace
}  // namespace striate::config
